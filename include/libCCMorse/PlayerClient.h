#pragma once

#include <string>

#include "libplayerc++/playerclient.h"

namespace CCMorse {

class MorseClient;

/// The connection to a server, Player's PlayerClient (thesis 3.1.3); Player's headers document it.
/// With a simulator everything is redirected to the MorseClient of its address, which several
/// PlayerClients share; the last one that is deleted sends the commands that wait and closes the
/// connection. Owned by the program; proxies may be deleted before or after it. Any thread.
class PlayerClient : public PlayerCc::PlayerClient {
 public:
  /// Connects; the port is the simulator's, 4000 for MORSE and ccmorse. For localhost with port
  /// 4000 or 6665 the environment's CCMORSE_HOST and CCMORSE_PORT are taken, where set, so that
  /// `ccmorse batch` can run many programs at once. Any address that Player's takes will do:
  /// "sim:..." for a simulation within the program, and "player://..."; over Player's protocol
  /// GetMorseClient() and the `robot` of proxies have no meaning. Throws MorseError within 5 s when
  /// nobody answers.
  explicit PlayerClient(const std::string& host = "localhost", int port = 6665);
  ~PlayerClient() override;
};

}  // namespace CCMorse
