// `ccmorse check`: whether simulations can run here, and what is missing.

#include <arpa/inet.h>
#include <fmt/core.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "scene/field.h"
#include "scene/scenario.h"
#include "scene/world_folders.h"
#include "servers/web/web_server.h"
#include "tools/child_process.h"
#include "tools/command_line.h"
#include "tools/environments.h"
#include "tools/scene_choice.h"

namespace ccmorse::tools {
namespace {

namespace fs = std::filesystem;

// Prints one line for each thing looked at.
class Findings {
 public:
  static void Good(const std::string& text) { fmt::print("  ok       {}\n", text); }
  /// What not everybody needs.
  static void Note(const std::string& text) { fmt::print("  note     {}\n", text); }
  void Problem(const std::string& text) {
    fmt::print("  PROBLEM  {}\n", text);
    ++problems_;
  }
  int problems() const { return problems_; }

 private:
  int problems_ = 0;
};

bool IsFree(std::uint16_t port) {
  const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (server < 0) return false;
  const int yes = 1;
  (void)::setsockopt(server, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  sockaddr generic{};
  static_assert(sizeof generic == sizeof address);
  std::copy_n(reinterpret_cast<const char*>(&address), sizeof address,
              reinterpret_cast<char*>(&generic));
  const bool free = ::bind(server, &generic, sizeof generic) == 0;
  ::close(server);
  return free;
}

void CheckParts(Findings& findings) {
  const std::vector<std::string> scenarios = scene::ListScenarios();
  if (scenarios.empty()) {
    findings.Problem("no scenarios are installed; looked in " +
                     scene::Listed(scene::WorldFolders()));
  } else {
    Findings::Good(fmt::format("{} scenarios: {}", scenarios.size(), scene::Listed(scenarios)));
  }
  if (const std::string web = servers::FindWebFolder(); !web.empty()) {
    Findings::Good("the live view's page is in " + web);
  } else {
    Findings::Note(
        "the live view has no page, so only --headless runs are of use: build web/ "
        "(docs/view.md) or set CCMORSE_WEB");
  }
  for (const auto& [port, what] : {std::pair{4000, "MORSE's services"}, {6665, "Player"}}) {
    if (IsFree(static_cast<std::uint16_t>(port))) {
      Findings::Good(fmt::format("port {} is free, for {}", port, what));
    } else {
      Findings::Note(
          fmt::format("port {}, for {}, is in use: does a simulation run? Else --port 0 "
                      "takes free ones",
                      port, what));
    }
  }
}

void CheckPrograms() {
  struct Program {
    const char* name;
    const char* what_for;
  };
  for (const Program& each : {Program{"g++", "building programs for robots"},
                              {"make", "the course's Makefiles"},
                              {"python3", "MORSE's builder scripts and clients"},
                              {"bwrap", "grading programs of others (Debian's bubblewrap)"}}) {
    if (!FindInPath(each.name).empty()) {
      Findings::Good(fmt::format("{} is there, for {}", each.name, each.what_for));
    } else {
      Findings::Note(fmt::format("there is no {}, for {}", each.name, each.what_for));
    }
  }
}

void CheckEnvironments(const std::string& program, Findings& findings) {
  try {
    const Environments environments;
    const std::vector<Environment> all = environments.List();
    Findings::Good(fmt::format("{} environment{} in {}", all.size(), all.size() == 1 ? "" : "s",
                               environments.config_file().string()));
    for (const Environment& each : all) {
      std::error_code failed;
      if (!fs::is_directory(each.folder, failed)) {
        findings.Problem(
            fmt::format("environment '{}': {} is gone; {} import -f NEW_PLACE {}, or "
                        "{} rm {}",
                        each.name, each.folder.string(), program, each.name, program, each.name));
      } else if (!DefaultScene(each.folder)) {
        Findings::Note(fmt::format("environment '{}': {} has no scene to start with", each.name,
                                   each.folder.string()));
      }
    }
    // Whoever cannot write there can create and import nothing.
    fs::path folder = environments.config_file().parent_path();
    std::error_code failed;
    if (!fs::exists(folder, failed)) folder = folder.parent_path();
    if (::access(folder.c_str(), W_OK) != 0) {
      findings.Problem(
          fmt::format("{} cannot be written: no environment can be created or "
                      "imported; set HOME to a folder that can",
                      folder.string()));
    }
  } catch (const Error& error) {
    findings.Problem(error.what());
  }
}

int Check(const std::string& program) {
  Findings findings;
  fmt::print("* ccmorse {}\n", CCMORSE_VERSION);
  CheckParts(findings);
  CheckPrograms();
  CheckEnvironments(program, findings);
  if (findings.problems() > 0) {
    fmt::print("* {} problem{}, see above.\n", findings.problems(),
               findings.problems() == 1 ? "" : "s");
    return 1;
  }
  fmt::print("* Your environment is set up to run simulations.\n");
  return 0;
}

}  // namespace

void AddCheckCommand(CommandLine& line) {
  line.Add("check", "see whether simulations can run here, and what is missing",
           [program = line.program()] { return Check(program); })
      .footer("Exit status: 1 where something has to be put right; notes are no problems.");
}

}  // namespace ccmorse::tools
