#pragma once

#include <memory>
#include <vector>

#include "imr-h/imr_config.h"
#include "imr-h/map_grid.h"
#include "imr-h/thread.h"
#include "plan.h"
#ifdef _MORSE
#include "imr-h/canvas.h"
#include "libCCMorse/CCMorse.h"
#else
#include "libPlayer/LaserProxy.h"
#include "libPlayer/PlayerClient.h"
#include "libPlayer/Position2dProxy.h"
#endif

namespace imr {

/// The thread that gathers data and drives (thesis 4.3.3): reads pose and laser, puts the scan into
/// the map, and follows the plan of CExploration, which is the other thread.
///
/// Once in PLAN_EVERY scans it hands a copy of the map out, and waits for the plan that answers it:
/// so a plan begins where the robot is, and a run in lock-step, where time waits for it, is the
/// same every time. Elsewhere a planner that takes longer than PATIENCE finds the robot standing.
/// Public functions are for any thread.
class CControl : public imr::concurrent::CThread {
 public:
  static constexpr int PLAN_EVERY = 10;    ///< scans
  static constexpr double PATIENCE = 1.0;  ///< s, of wall-clock time

  /// Adds its options to `config`. Throws imr::bad_usage if one is there already.
  static CConfig& getConfig(CConfig& config);

  /// Connects. Throws CCMorse::MorseError if there is no server or no such device. `map` is what is
  /// filled; only this object uses it until the thread has ended. Both outlive the object.
  CControl(const CConfig& config, CMapGrid& map);
  ~CControl() override;

  /// Asks the thread to end, and with it whoever waits for a map.
  void stop() override;

  /// Waits until the next plan is due; then copies the map and where the robot is. False when the
  /// run is over. For the planning thread.
  bool waitForMap(CMapGrid& copy, SPosition& position);
  /// Answers waitForMap().
  void setPlan(SPlan plan);

  bool isAlive();       ///< false after an error
  bool isExplored();    ///< whether a plan said that nothing is left
  double getSeconds();  ///< simulated time from the first scan to the last

 protected:
  void threadBody() override;

 private:
  void main();
  void exchange();  // hands the map out, and takes the plan
  void draw();

  // --- What a student writes, in control.cc

  /// Puts the last scan into `map`, as seen from `position`.
  void updateMap();
  /// The speeds that follow `plan.path` from `position`: v, m/s, and w, rad/s.
  void followPath(double& v, double& w);

  const CConfig& cfg;
  CMapGrid& map;
  std::unique_ptr<CCMorse::PlayerClient> client;
  std::unique_ptr<CCMorse::LaserProxy> laser;
  std::unique_ptr<CCMorse::Position2dProxy> position2d;  // tells where the robot is
  std::unique_ptr<CCMorse::Position2dProxy> wheels;      // takes speeds
#ifdef _MORSE
  std::unique_ptr<CCanvas> canvas;
#endif
  SPosition position;      // of this thread, as what follows
  SPlan plan;              // the last one
  bool drawn = false;      // whether it was drawn
  bool timeWaits = false;  // no simulated time goes by while this thread waits
  std::size_t next = 0;    // the corner of plan.path that is driven to; 0 with a new plan

  Mutex mtx;
  Condition changed;
  // Under mtx.
  bool quit = false;
  bool alive = true;
  bool explored = false;
  bool due = false;  // a plan is asked for
  double seconds = 0.0;
  std::unique_ptr<CMapGrid> copy;  // of the map, for the plan that is due
  SPosition copyPosition;
  std::unique_ptr<SPlan> answer;
};

}  // namespace imr
