#include "tools/open_browser.h"

#include <fcntl.h>
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
  // A grandchild, which init inherits: the browser may outlive us and nobody waits for it. What it
  // says is for nobody, as it names each browser that is not there.
  if (::fork() == 0) {
    const pid_t opener = ::fork();
    if (opener == 0) {
      sigset_t none;
      sigemptyset(&none);
      ::sigprocmask(SIG_SETMASK, &none, nullptr);
      const int nowhere = ::open("/dev/null", O_RDWR);
      for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, file);
      ::execlp(program, program, address.c_str(), nullptr);
      ::_exit(127);
    }
    int status = 0;
    if (opener < 0 || ::waitpid(opener, &status, 0) < 0 || status != 0) {
      fmt::print(stderr, "No browser can be opened from here; go to {}\n", address);
    }
  }
  ::_exit(0);
}

}  // namespace ccmorse::tools
