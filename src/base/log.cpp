#include "base/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <deque>
#include <memory>
#include <mutex>

namespace ccmorse {
namespace {

spdlog::level::level_enum ToSpdlog(LogLevel level) {
  switch (level) {
    case LogLevel::kDebug:
      return spdlog::level::debug;
    case LogLevel::kInfo:
      return spdlog::level::info;
    case LogLevel::kWarning:
      return spdlog::level::warn;
    case LogLevel::kError:
      return spdlog::level::err;
    case LogLevel::kOff:
      break;
  }
  return spdlog::level::off;
}

spdlog::logger& Logger() {
  static const std::shared_ptr<spdlog::logger> logger = [] {
    auto made = std::make_shared<spdlog::logger>("ccmorse",
                                                 std::make_shared<spdlog::sinks::stderr_sink_mt>());
    made->set_pattern("[%l] %v");
    made->flush_on(spdlog::level::debug);
    return made;
  }();
  return *logger;
}

constexpr std::size_t kMostKept = 200;  // lines

// The newest lines. Its lock is held for moments only.
class Memory {
 public:
  void Add(LogLevel level, std::string_view text) {
    const std::lock_guard lock(mutex_);
    entries_.push_back({++count_, level, std::string(text)});
    if (entries_.size() > kMostKept) entries_.pop_front();
  }
  std::vector<LogEntry> After(std::uint64_t number) {
    const std::lock_guard lock(mutex_);
    std::vector<LogEntry> found;
    for (const LogEntry& entry : entries_) {
      if (entry.number > number) found.push_back(entry);
    }
    return found;
  }

 private:
  std::mutex mutex_;
  std::deque<LogEntry> entries_;
  std::uint64_t count_ = 0;
};

Memory& Kept() {
  static Memory memory;
  return memory;
}

}  // namespace

void SetLogLevel(LogLevel level) { Logger().set_level(ToSpdlog(level)); }

void LogLine(LogLevel level, std::string_view text) {
  if (!Logger().should_log(ToSpdlog(level))) return;
  Kept().Add(level, text);
  Logger().log(ToSpdlog(level), spdlog::string_view_t(text.data(), text.size()));
}

std::vector<LogEntry> RecentLog(std::uint64_t after) { return Kept().After(after); }

}  // namespace ccmorse
