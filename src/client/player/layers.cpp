#include "client/player/layers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libCCMorse/MorseClient.h"
#include "libCCMorse/MorseError.h"

namespace CCMorse {

namespace {

constexpr double kQuestionPeriod = 1.0;      // s, simulated
constexpr std::size_t kMostLayers = 256;     // layers, of the simulator's list
constexpr std::size_t kLongestListed = 100;  // bytes of a name there

// A layer as it is looked at from above.
struct Sheet {
  const std::uint32_t* cells = nullptr;
  std::uint32_t own = 0;
  std::uint32_t key = 0;  // 0: none
  double opacity = 1.0;
};

unsigned char Byte(double channel) { return static_cast<unsigned char>(std::lround(channel)); }

// From the topmost sheet downwards: a colour counts by what the sheets above let through. 0 where
// all are clear.
std::uint32_t Look(const std::vector<Sheet>& sheets, std::size_t at) {
  double light = 1.0;
  double r = 0.0;
  double g = 0.0;
  double b = 0.0;
  for (const Sheet& sheet : sheets) {
    std::uint32_t cell = sheet.cells[at];
    if (cell == 0) continue;
    cell = Layers::kColored | (cell == Layers::kOwn ? sheet.own : cell);
    if (cell == sheet.key) continue;
    if (light == 1.0 && sheet.opacity == 1.0) return cell;
    const Color_t color = Layers::Unpack(cell);
    const double share = light * sheet.opacity;
    r += share * color.r;
    g += share * color.g;
    b += share * color.b;
    light *= 1.0 - sheet.opacity;
    if (light == 0.0) break;
  }
  if (light == 1.0) return 0;
  return Layers::kColored | Layers::Pack({Byte(r + light * kWhite.r), Byte(g + light * kWhite.g),
                                          Byte(b + light * kWhite.b)});
}

}  // namespace

Layers::Layers(MorsePen& pen) : pen_(pen) { Resize(); }

GridMap& Layers::Add(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto same = [&](const auto& map) { return map->name_ == name; };
  if (std::any_of(maps_.begin(), maps_.end(), same)) {
    throw MorseError("there is a layer '" + name + "' already", "WindowProxy::AddLayer()");
  }
  std::unique_ptr<GridMap> map(new GridMap(*this, name, made_++));
  GridMap& added = *map;
  maps_.push_back(std::move(map));
  Order();
  list_changed_ = true;
  return added;
}

GridMap* Layers::Find(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  for (const auto& map : maps_) {
    if (map->name_ == name) return map.get();
  }
  return nullptr;
}

void Layers::Remove(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto same = [&](const auto& map) { return map->name_ == name; };
  const auto found = std::find_if(maps_.begin(), maps_.end(), same);
  if (found == maps_.end()) {
    throw MorseError("there is no layer '" + name + "'", "WindowProxy::RemoveLayer()");
  }
  MarkUnclear(**found);
  maps_.erase(found);
  list_changed_ = true;
}

std::vector<std::string> Layers::Names() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> names;
  for (const auto& map : maps_) names.push_back(map->name_);
  return names;
}

void Layers::Restart() {
  const std::lock_guard lock(mutex_);
  Resize();
}

void Layers::SendAll() {
  const std::lock_guard lock(mutex_);
  // What was drawn has to be drawn over, if only with white: so it stays known as drawn.
  for (std::uint32_t& cell : sent_) {
    if (cell != 0) cell = kOwn;
  }
  std::fill(marked_.begin(), marked_.end(), 1);
  any_marked_ = true;
}

void Layers::Compose() {
  const std::lock_guard lock(mutex_);
  if (pen_.GetWidth() != width_ || pen_.GetHeight() != height_) Resize();
  if (!any_marked_) return;
  any_marked_ = false;
  std::vector<Sheet> sheets;
  for (auto map = maps_.rbegin(); map != maps_.rend(); ++map) {
    const GridMap& layer = **map;
    if (!layer.visible_ || !layer.shown_ || layer.transparency_ == 1.0) continue;
    sheets.push_back({layer.cells_.data(), Pack(layer.color_),
                      layer.key_ ? kColored | Pack(*layer.key_) : 0, 1.0 - layer.transparency_});
  }
  changes_.clear();
  for (auto next = std::find(marked_.begin(), marked_.end(), 1); next != marked_.end();
       next = std::find(next, marked_.end(), 1)) {
    *next = 0;
    const auto at = static_cast<std::size_t>(next - marked_.begin());
    std::uint32_t cell = Look(sheets, at);
    // A cell cannot become as if it had never been drawn on; white is how such a one reads.
    if (cell == 0 && sent_[at] != 0) cell = kColored | Pack(kWhite);
    if (cell == sent_[at]) continue;
    sent_[at] = cell;
    const auto across = static_cast<std::size_t>(width_);
    changes_.push_back(
        {{static_cast<int>(at % across), static_cast<int>(at / across)}, Unpack(cell)});
  }
  pen_.UpdateImageData(changes_);
}

void Layers::Ask() {
  const std::lock_guard lock(mutex_);
  if (list_changed_) SendList();
  const double now = pen_.GetClient().GetTime();
  if (maps_.empty() || now < next_question_) return;
  next_question_ = now + kQuestionPeriod;
  pen_.AskLayers([weak = weak_from_this()](const std::vector<CanvasLayer_t>& list) {
    if (const auto layers = weak.lock()) layers->Switch(list);
  });
}

void Layers::Retire() {
  const std::lock_guard lock(mutex_);
  if (!maps_.empty()) pen_.SetLayers({});
}

void Layers::SendList() {
  list_changed_ = false;
  std::vector<CanvasLayer_t> list;
  for (const auto& map : maps_) {
    // What the list has no room for is drawn all the same.
    if (map->name_.empty() || map->name_.size() > kLongestListed) continue;
    if (list.size() < kMostLayers) list.push_back({map->name_, map->priority_, map->visible_});
  }
  pen_.SetLayers(list);
}

void Layers::Switch(const std::vector<CanvasLayer_t>& list) {
  const std::lock_guard lock(mutex_);
  for (const auto& map : maps_) {
    const auto named = std::find_if(list.begin(), list.end(), [&](const CanvasLayer_t& layer) {
      return layer.name == map->name_;
    });
    if (named == list.end() || named->shown == map->shown_) continue;
    map->shown_ = named->shown;
    MarkUnclear(*map);
  }
}

void Layers::Order() {
  std::sort(maps_.begin(), maps_.end(), [](const auto& a, const auto& b) {
    return std::pair(a->priority_, a->serial_) < std::pair(b->priority_, b->serial_);
  });
}

void Layers::Resize() {
  width_ = pen_.GetWidth();
  height_ = pen_.GetHeight();
  const std::size_t cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  for (const auto& map : maps_) {
    map->cells_.assign(cells, 0);
    map->trace_end_.reset();
  }
  marked_.assign(cells, 0);
  sent_.assign(cells, 0);
  any_marked_ = false;
}

void Layers::MarkUnclear(const GridMap& map) {
  for (std::size_t i = 0; i < map.cells_.size(); ++i) {
    if (map.cells_[i] != 0) Mark(i);
  }
}

}  // namespace CCMorse
