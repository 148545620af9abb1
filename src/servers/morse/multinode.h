#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include "scene/scenario.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// One of several simulators that share a scene in lock-step (specs: morse.md A.7): it simulates
/// the robots that are its own, with their devices. Those of others are bodies in it, which do what
/// their own simulators say, so that what it simulates is the same, bit for bit, as in a run of all
/// on one node. Boxes that are raised by services and the grid map on the floor are not shared.
///
/// On the thread of the loop, which is the one that runs the io_context.
class Multinode {
 public:
  /// The robots of a scenario that others have, when this is the node `node`.
  static std::set<std::string> External(const scene::MultinodeDef& def, const std::string& node);

  /// Connects to the server; the devices of others' robots are silent and unseen from now on, so
  /// this comes before whoever serves the simulation. Throws Error when the server is not there.
  /// `goes_on` is asked while the others are waited for: false ends the waiting.
  Multinode(boost::asio::io_context& io, sim::Simulation& simulation,
            const scene::MultinodeDef& def, const std::string& node, std::function<bool()> goes_on);
  ~Multinode();
  Multinode(const Multinode&) = delete;
  Multinode& operator=(const Multinode&) = delete;

  /// The robots of others.
  const std::set<std::string>& external() const;

  /// Tells the others of the state at the end, when all have come to it: the simulation's hash is
  /// that of the whole scene then. Throws Error when the server has gone.
  void Finish();

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace ccmorse::servers
