#include "tools/open_browser.h"

#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace ccmorse::tools {

void OpenBrowser(const std::string& address) {
  const char* const program = "xdg-open";
  const pid_t child = ::fork();
  if (child != 0) {
    if (child > 0) ::waitpid(child, nullptr, 0);
    return;
  }
  // A grandchild, which init inherits: the browser may outlive us and nobody waits for it.
  if (::fork() == 0) {
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    ::execlp(program, program, address.c_str(), nullptr);
    fmt::print(stderr, "cannot open a browser (there is no {}); go to {}\n", program, address);
  }
  ::_exit(0);
}

}  // namespace ccmorse::tools
