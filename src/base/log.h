#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ccmorse {

enum class LogLevel { kDebug, kInfo, kWarning, kError, kOff };

/// Lines below this level are dropped, with kOff all; kInfo at start. Thread safe.
void SetLogLevel(LogLevel level);

/// Writes one line "[warning] text" to stderr, flushed. Thread safe. Log through the functions
/// below.
void LogLine(LogLevel level, std::string_view text);

/// A line of the log, as it is kept for those who look later.
struct LogEntry {
  std::uint64_t number = 0;  ///< lines are numbered from 1
  LogLevel level = LogLevel::kInfo;
  std::string text;
};

/// The newest lines that were not dropped and whose number is higher than `after`, oldest first;
/// 200 are kept. Thread safe.
std::vector<LogEntry> RecentLog(std::uint64_t after = 0);

template <typename... Args>
void LogDebug(fmt::format_string<Args...> format, Args&&... args) {
  LogLine(LogLevel::kDebug, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void LogInfo(fmt::format_string<Args...> format, Args&&... args) {
  LogLine(LogLevel::kInfo, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void LogWarning(fmt::format_string<Args...> format, Args&&... args) {
  LogLine(LogLevel::kWarning, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void LogError(fmt::format_string<Args...> format, Args&&... args) {
  LogLine(LogLevel::kError, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace ccmorse
