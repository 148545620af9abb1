#pragma once

#include <string>

namespace ccmorse::tools {

/// Shows an address in the user's browser, in a process that nobody waits for. Where there is none,
/// standard error says so.
void OpenBrowser(const std::string& address);

}  // namespace ccmorse::tools
