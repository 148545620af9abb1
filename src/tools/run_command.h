#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ccmorse::tools {

/// What `ccmorse run` was asked for; what is not set comes from the scenario.
struct RunArguments {
  std::string scenario;   ///< name or path
  std::string name;       ///< of the environment that it belongs to, or ""
  bool headless = false;  ///< no live view
  /// Of a builder script, in its sys.argv behind "--".
  std::vector<std::string> script_arguments;
  std::optional<std::string> pace;   ///< "real", "lockstep" or "max"
  double seconds = 0.0;              ///< simulated; 0: until stopped
  int threads = 0;                   ///< that share the work; 0: as many as are sensible
  std::optional<std::int64_t> seed;  ///< >= 0
  int clients = 1;                   ///< lock-step: wait for so many
  double client_timeout = 10.0;      ///< lock-step: s of wall time a client may hang; 0: for ever
  double component_timeout = 1.0;    ///< s of wall time that code of a component's own may take
  int port = 4000;                   ///< 0: any free one
  int stream_port = 60000;           ///< 0: any free ones
  int view_port = 8000;              ///< of the live view, or the next free one; 0: any
  std::string token;                 ///< that the view's address must carry; "": none
  bool view_read_only = false;       ///< whoever sees it may only look
  bool open = false;                 ///< show the view in the user's browser
  /// Player's port of the first robot, 0: any free ones. Where not given, Player's own, and the run
  /// goes on without it if that is taken; with `port` 0 any free ones.
  std::optional<int> player_port;
  bool no_player = false;            ///< leaves Player's protocol out
  std::vector<std::string> mirrors;  ///< servers::MirrorTarget::Parse
  std::string bind = "127.0.0.1";
  std::string out = ".";                    ///< folder for pictures that clients save
  std::string picture;                      ///< PNG of the arena from above at the end; "": none
  std::string report;                       ///< JSON file; "": none
  std::string record;                       ///< MCAP file; "": none
  std::string record_data = "poses";        ///< servers::RecordOptions::data
  std::optional<std::uint64_t> hash_every;  ///< ticks, > 0
  bool quiet = false;
  bool contest = false;    ///< servers::ServiceDirectory::set_contest()
  int listen_socket = -1;  ///< servers::MorseServerOptions::listen_socket
};

/// `ccmorse run`: returns the exit status. Throws Error for what the user can put right.
int Run(const RunArguments& arguments);

/// What `ccmorse convert` was asked for.
struct ConvertArguments {
  std::string file;  ///< a .world, a .cfg or a scenario
  std::string out;   ///< JSON file; "": standard output
};

/// `ccmorse convert`: writes a world of Stage or a .cfg of Player as a scenario, and names on
/// standard error what a scenario cannot have. Returns the exit status. Throws Error.
int Convert(const ConvertArguments& arguments);

}  // namespace ccmorse::tools
