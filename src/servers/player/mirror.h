#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "servers/morse/service_directory.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// Which Player server a robot of the simulation mirrors.
struct MirrorTarget {
  std::string robot;  ///< of the simulation; empty: the first
  std::string host = "localhost";
  int port = 6665;

  /// Reads "player://HOST[:PORT]", HOST[:PORT] or either of them after "ROBOT=". Throws Error that
  /// says what is expected.
  static MirrorTarget Parse(std::string_view text);
};

/// Shows a real robot in the simulation (thesis 5.1; N06): a client of a Player server, the robot's
/// own, that puts one robot of the simulation where the real one says it is and has its scanner
/// show the real scan. The pose comes from position2d:2, SyRoTek's global localisation, or from
/// position2d:0 where there is none; the scan from laser:0, beam by beam the real one nearest in
/// bearing, so the two scanners need not be alike.
///
/// What comes goes through the ServiceDirectory, so a record holds it. A connection that fails is
/// made anew every 2 s, with one line in the log for each change. Works in handlers of `io`, on the
/// simulation's thread.
class Mirror {
 public:
  /// Everything outlives the mirror. Begins to connect when `io` runs. Throws Error when there is
  /// no such robot.
  Mirror(boost::asio::io_context& io, sim::Simulation& simulation, ServiceDirectory& directory,
         const MirrorTarget& target);
  ~Mirror();
  Mirror(const Mirror&) = delete;
  Mirror& operator=(const Mirror&) = delete;

 private:
  class Link;
  std::shared_ptr<Link> link_;
};

}  // namespace ccmorse::servers
