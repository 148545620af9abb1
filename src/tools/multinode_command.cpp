// `ccmorse multinode-server`: what runs between the simulators of one scene (specs: morse.md A.7).

#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <string>

#include "servers/morse/multinode_server.h"
#include "tools/command_line.h"
#include "tools/stop_signals.h"

namespace ccmorse::tools {
namespace {

struct MultinodeArguments {
  std::string bind = "127.0.0.1";
  int port = 65000;
};

int Serve(const MultinodeArguments& arguments) {
  const StopSignals signals;
  servers::MultinodeServer server(arguments.bind, arguments.port);
  const StopSignalWatch watch(signals, server.io(), [&server](int) { server.Stop(); });
  fmt::print("Multinode server on {} port {}\n", arguments.bind, server.port());
  std::fflush(stdout);
  server.Run();
  return 0;
}

}  // namespace

void AddMultinodeServerCommand(CommandLine& line) {
  const auto arguments = std::make_shared<MultinodeArguments>();
  CLI::App& command =
      line.Add("multinode-server", "keep the simulators together that share one scene",
               [arguments] { return Serve(*arguments); });
  command.add_option("--port", arguments->port, "to listen on; 0 takes any free one  [65000]")
      ->check(CLI::Range(0, 65535))
      ->type_name("N");
  command.add_option("--bind", arguments->bind, "address to listen on  [127.0.0.1]")
      ->type_name("ADDRESS");
  command.footer(
      "Each simulator has the robots that env.configure_multinode() gives its node, and all go in\n"
      "lock-step, so that the run is the same as on one node. Ctrl-C ends the server.\n"
      "Example, for a scene with the nodes A and B:\n"
      "  ccmorse multinode-server &\n"
      "  ccmorse run scene.py --name A &\n"
      "  ccmorse run scene.py --name B --port 4100 --stream-port 61000");
}

}  // namespace ccmorse::tools
