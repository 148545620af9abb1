#include <mutex>

#include "client/player/layers.h"
#include "client/player/proxy_lookup.h"
#include "client/player/proxy_state.h"
#include "libCCMorse/MorseClient.h"
#include "libCCMorse/MorseError.h"
#include "libCCMorse/PlayerClient.h"
#include "libCCMorse/WindowProxy.h"

namespace CCMorse {

namespace {

struct Single {
  std::mutex mutex;
  WindowProxy* window = nullptr;  // owned by the program, which deletes it
};

Single& TheSingle() {
  static Single single;
  return single;
}

MorsePen& FirstPen(MorseClient& client) {
  for (const MorseRobot* robot : client.GetRobots()) {
    if (MorsePen* pen = robot->FindDevice<MorsePen>()) return *pen;
  }
  throw MorseError("the simulation has no pen to draw with", "WindowProxy::GetInstance()");
}

}  // namespace

WindowProxy::WindowProxy(PlayerClient* client, MorsePen& pen)
    : MorseProxy(client, 0, "WindowProxy", "window", std::make_shared<PlayerCc::NoState>()),
      pen_(&pen),
      layers_(std::make_shared<Layers>(pen)) {
  // Held by the call: it may be on its way when the window goes.
  before_read_ = pen.GetClient().BeforeRead([layers = layers_] {
    layers->Compose();
    layers->Ask();
  });
}

WindowProxy& WindowProxy::GetInstance(PlayerClient* client, int width, int height) {
  RequireClient(client, "WindowProxy::GetInstance()");
  MorsePen& pen = FirstPen(client->GetMorseClient());
  pen.ResizeCanvas(width, height);
  Single& single = TheSingle();
  const std::lock_guard lock(single.mutex);
  if (single.window && single.window->pen_ == &pen) {
    single.window->layers_->Restart();
    return *single.window;
  }
  if (single.window) {
    throw MorseError("there is a window of another client; delete it first",
                     "WindowProxy::GetInstance()");
  }
  single.window = new WindowProxy(client, pen);
  return *single.window;
}

WindowProxy& WindowProxy::GetInstance() {
  Single& single = TheSingle();
  const std::lock_guard lock(single.mutex);
  if (!single.window) {
    throw MorseError("there is no window yet: call GetInstance(client, width, height) first",
                     "WindowProxy::GetInstance()");
  }
  return *single.window;
}

WindowProxy::~WindowProxy() {
  before_read_.reset();
  layers_->Compose();  // what was drawn last is seen, too
  layers_->Retire();
  Single& single = TheSingle();
  const std::lock_guard lock(single.mutex);
  if (single.window == this) single.window = nullptr;
}

Color_t WindowProxy::GetPixel(int x, int y) {
  layers_->Compose();
  return pen_->GetPixel(x, y);
}

std::vector<Color_t> WindowProxy::GetImageData() {
  layers_->Compose();
  return pen_->GetImageData();
}

void WindowProxy::SaveImageCopy(const std::string& name) {
  layers_->Compose();
  pen_->SaveImageCopy(name);
}

void WindowProxy::SetImageData(const std::vector<Color_t>& image) { pen_->SetImageData(image); }

void WindowProxy::UpdateImageData(const std::vector<PixelUpdate_t>& pixels) {
  pen_->UpdateImageData(pixels);
}

GridMap& WindowProxy::AddLayer(const std::string& name, Color_t color, int priority,
                               double transparency) {
  GridMap& layer = layers_->Add(name);
  try {
    layer.SetTransparency(transparency);
  } catch (const MorseError&) {
    layers_->Remove(name);
    throw;
  }
  layer.SetColor(color);
  layer.SetPriority(priority);
  return layer;
}

GridMap& WindowProxy::GetLayer(const std::string& name) const {
  if (GridMap* const layer = layers_->Find(name)) return *layer;
  std::string known;
  for (const std::string& other : layers_->Names()) known += (known.empty() ? "" : ", ") + other;
  throw MorseError("there is no layer '" + name + "'; " +
                       (known.empty() ? "none was made" : "known are " + known),
                   "WindowProxy::GetLayer()");
}

bool WindowProxy::HasLayer(const std::string& name) const { return layers_->Find(name) != nullptr; }
std::vector<std::string> WindowProxy::GetLayerNames() const { return layers_->Names(); }
void WindowProxy::RemoveLayer(const std::string& name) { layers_->Remove(name); }
void WindowProxy::Redraw() { layers_->SendAll(); }

void WindowProxy::ResizeCanvas(int width, int height) {
  pen_->ResizeCanvas(width, height);
  layers_->Restart();
}

int WindowProxy::GetWidth() const { return pen_->GetWidth(); }
int WindowProxy::GetHeight() const { return pen_->GetHeight(); }
double WindowProxy::GetCellSize() const { return pen_->GetCellSize(); }
void WindowProxy::RefreshSize() { pen_->RefreshSize(); }
int WindowProxy::GetX(double x) const { return pen_->GetX(x); }
int WindowProxy::GetY(double y) const { return pen_->GetY(y); }

}  // namespace CCMorse
