// The given part of CControl: threads, connection and drawing. control.cc is yours.

#include <chrono>
#include <utility>

#include "control.h"
#include "imr-h/logging.h"
#include "libCCMorse/MorseError.h"

namespace imr {

#ifdef _MORSE
namespace {

// Hands the map in, for `ccmorse grade`. Simulators that do not grade have nobody to hand it to.
void submit(CCMorse::PlayerClient& client, const CMapGrid& map) {
  std::string cells;
  for (const double cell : map.cells()) cells += cell < 0.35 ? '0' : cell > 0.65 ? '1' : '?';
  for (const CCMorse::MorseRobot* robot : client.GetMorseClient().GetRobots()) {
    auto* const answers = robot->FindDevice<CCMorse::MorseAnswers>();
    if (answers == nullptr) continue;
    answers->SubmitGrid("map", map.getWidth(), map.getHeight(), cells, map.getCellSize());
    return;
  }
}

}  // namespace
#endif  // _MORSE

CConfig& CControl::getConfig(CConfig& config) {
#ifdef _MORSE
  config.add<std::string>("host", "morse server hostname", "localhost");
  config.add<int>("port", "morse server port", 4000);
  config.add<std::string>("save", "have the simulator save the canvas as this .png at the end", "");
#else
  config.add<std::string>("host", "syrotek server hostname", "syrotek.felk.cvut.cz");
  config.add<int>("port", "syrotek server port", 38000);
#endif  // _MORSE
  config.add<int>("position2d-index", "position2d index of the pose in the arena", 2);
  config.add<int>("wheels-index", "position2d index of what takes speeds", 0);
  config.add<double>("seconds", "explore no longer than this, by the time of the scans", 400.0);
  return config;
}

CControl::CControl(const CConfig& config, CMapGrid& grid) : cfg(config), map(grid) {
  client =
      std::make_unique<CCMorse::PlayerClient>(cfg.get<std::string>("host"), cfg.get<int>("port"));
  laser = std::make_unique<CCMorse::LaserProxy>(client.get(), 0);
  position2d = std::make_unique<CCMorse::Position2dProxy>(
      client.get(), static_cast<unsigned>(cfg.get<int>("position2d-index")));
  wheels = std::make_unique<CCMorse::Position2dProxy>(
      client.get(), static_cast<unsigned>(cfg.get<int>("wheels-index")));
#ifdef _MORSE
  timeWaits = client->GetMorseClient().GetPace() == "lockstep";
  canvas = std::make_unique<CCanvas>(client.get(), map.getWidth(), map.getHeight());
  // From the lowest to the topmost (figure 4.10).
  canvas->layer("map", CCanvas::Black);
  canvas->layer("inflated", CCanvas::Blue, 0.5);
  canvas->layer("frontiers", CCanvas::Purple);
  canvas->layer("path", CCanvas::Orange);
  canvas->layer("trace", CCanvas::Red);
#endif  // _MORSE
}

CControl::~CControl() {
  stop();
  join();
}

void CControl::stop() {
  ScopedLock lk(mtx);
  quit = true;
  changed.notify_all();
}

bool CControl::isAlive() {
  ScopedLock lk(mtx);
  return alive;
}

bool CControl::isExplored() {
  ScopedLock lk(mtx);
  return explored;
}

double CControl::getSeconds() {
  ScopedLock lk(mtx);
  return seconds;
}

bool CControl::waitForMap(CMapGrid& to, SPosition& at) {
  ScopedLock lk(mtx);
  changed.wait(lk, [this] { return quit || due; });
  if (quit) return false;
  due = false;
  to = *copy;
  at = copyPosition;
  return true;
}

void CControl::setPlan(SPlan made) {
  ScopedLock lk(mtx);
  answer = std::make_unique<SPlan>(std::move(made));
  changed.notify_all();
}

void CControl::exchange() {
  ScopedLock lk(mtx);
  copy = std::make_unique<CMapGrid>(map);
  copyPosition = position;
  due = true;
  answer.reset();
  changed.notify_all();
  const auto over = [this] { return quit || answer != nullptr; };
  if (timeWaits) {
    changed.wait(lk, over);
  } else if (!changed.wait_for(lk, std::chrono::duration<double>(PATIENCE), over)) {
    WARN("No plan came in time; the robot waits.");
    plan.path.clear();
  }
  if (answer == nullptr) return;
  plan = std::move(*answer);
  answer.reset();
  next = 0;
  drawn = false;
  explored = plan.done;
}

void CControl::threadBody() {
  bool failed = true;
  try {
    main();
    failed = false;
  } catch (CCMorse::MorseError& e) {
#ifdef _MORSE
    failed = !e.SimulationEnded();
#endif  // _MORSE
    if (failed) ERROR("Morse error: " << e.GetErrorStr() << " function: " << e.GetErrorFun());
  } catch (imr::exception& e) {
    ERROR("Imr error: " << e.what());
  }
  ScopedLock lk(mtx);
  alive = !failed;
  quit = true;
  changed.notify_all();
}

void CControl::main() {
  const double limit = cfg.get<double>("seconds");
  double start = -1.0;
  int scans = 0;
  wheels->SetMotorEnable(true);
  for (bool over = false; !over;) {
    client->Read();
#ifdef _MORSE
    // Player's server sends the newest when asked; Peek() would ask before the command is out.
    while (client->Peek(0)) client->Read();
#endif  // _MORSE
    if (!laser->IsFresh() || !laser->IsValid() || !position2d->IsValid()) continue;
    laser->NotFresh();
    position = {position2d->GetXPos(), position2d->GetYPos(), position2d->GetYaw()};
    updateMap();
    if (scans++ % PLAN_EVERY == 0) exchange();
    double v = 0.0;
    double w = 0.0;
    followPath(v, w);
    wheels->SetSpeed(v, w);
    draw();
    if (start < 0.0) start = laser->GetDataTime();
    ScopedLock lk(mtx);
    seconds = laser->GetDataTime() - start;
    over = quit || explored || seconds >= limit;
  }
  wheels->SetSpeed(0.0, 0.0);
  client->Read();  // takes the command along, and shows what was drawn last
#ifdef _MORSE
  submit(*client, map);
  const std::string picture = cfg.get<std::string>("save");
  if (!picture.empty()) canvas->save(picture);
#endif  // _MORSE
}

// What figure 4.10 shows: white free, black obstacles, grey unexplored; blue the dilated obstacles,
// purple frontiers, orange the path to one, red where the robot was.
void CControl::draw() {
#ifdef _MORSE
  canvas->draw(map);
  canvas->window().GetLayer("trace").AddToTrace(position.x, position.y);
  if (drawn) return;  // the rest changes with plans only
  drawn = true;
  for (const char* name : {"inflated", "frontiers", "path"}) canvas->clear(name);
  for (const SCell& cell : plan.inflated) {
    canvas->drawPixel(cell.x, cell.y, CCanvas::Blue, "inflated");
  }
  for (const SCell& cell : plan.frontiers) {
    canvas->drawPixel(cell.x, cell.y, CCanvas::Purple, "frontiers");
  }
  SPosition from = position;
  for (const SPosition& to : plan.path) {
    canvas->drawLine(map.getX(from.x), map.getY(from.y), map.getX(to.x), map.getY(to.y),
                     CCanvas::Orange, "path");
    from = to;
  }
#endif  // _MORSE
}

}  // namespace imr
