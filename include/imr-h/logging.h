#pragma once

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

namespace imr {

/// How grave a message is, from chatter to trouble; as a limit, the least that is still written.
enum class LogLevel {
  kDebug,  ///< Everything; what a program starts with.
  kInfo,
  kWarn,
  kError,
  kOff,  ///< Nothing; only for use as a limit.
};

/// A named source of messages. Programs get one from getLogger() and never delete it; loggers live
/// until the program ends. Thread safe.
class CLogger {
 public:
  explicit CLogger(const std::string& name) : name_(name) {}
  CLogger(const CLogger&) = delete;
  CLogger& operator=(const CLogger&) = delete;

  /// Stands between the prefix and the message of what is logged through it; may be empty.
  const std::string& getName() const { return name_; }

  /// Writes the line "INFO: text", or "INFO: name: text" for a logger with a name, to standard
  /// output, whole even when several threads write, and flushes it. The macros below check the
  /// level first; this function does not.
  void write(LogLevel level, const std::string& text) const;

 private:
  const std::string name_;
};

typedef CLogger* CLoggerPtr;

/// The logger of the program, never null; programs written for log4cxx say `using imr::logger;`.
extern CLoggerPtr logger;

/// The logger of that name; the same object for the same name. Thread safe.
CLoggerPtr getLogger(const std::string& name);

/// Makes getLogger(name) the program's logger. To be called from main() before other threads start.
void initLogger(const std::string& name);

/// The same, and takes the level from a log4cxx file: its line `log4j.rootLogger=INFO, ...` (or
/// rootCategory) sets it, the other lines, which say where to write, have no meaning here.
/// Throws io_error if the file cannot be read, bad_usage if the level is unknown.
void initLogger(const std::string& name, const std::string& configFile);

/// Flushes the output. Messages logged later are still written.
void shutdownLogger();

/// Sets the least grave level that is written, for the whole program. Thread safe.
///
/// Without a call it comes from the environment variable IMR_LOG (debug, info, warn, error or off),
/// and is debug if that is not set.
void setLogLevel(LogLevel level);

/// The level in force. Thread safe.
LogLevel getLogLevel();

/// Reads "debug", "info", "warn", "error" or "off", in any case. Throws bad_usage on other text.
LogLevel logLevelFromText(const std::string& text);

/// Whether a message of that level would be written. Thread safe.
bool isLogged(LogLevel level);

/// WARN and ERROR as functions.
void warn(const std::string& text);
void error(const std::string& text);

namespace detail {
/// The logger without a name, which the plain macros write to.
const CLogger& plainLogger();
}  // namespace detail

}  // namespace imr

// The macros take a stream expression, INFO("x " << 3), and write one line each (thesis C.2 l.70,
// 100, 152). They may be used in any namespace and as the branch of an `if` without braces. The
// expression is evaluated only if its level is written.
#define IMR_LOG_(log, level, expression)         \
  do {                                           \
    if (::imr::isLogged(level)) {                \
      std::ostringstream imr_log_stream_;        \
      imr_log_stream_ << expression;             \
      (log).write(level, imr_log_stream_.str()); \
    }                                            \
  } while (false)

// A program may be compiled with -DDEBUG, which these names must survive.
#undef DEBUG
#undef INFO
#undef WARN
#undef ERROR

#define DEBUG(str) IMR_LOG_(::imr::detail::plainLogger(), ::imr::LogLevel::kDebug, str)
#define INFO(str) IMR_LOG_(::imr::detail::plainLogger(), ::imr::LogLevel::kInfo, str)
#define WARN(str) IMR_LOG_(::imr::detail::plainLogger(), ::imr::LogLevel::kWarn, str)
#define ERROR(str) IMR_LOG_(::imr::detail::plainLogger(), ::imr::LogLevel::kError, str)

// The same through a logger of one's own, a CLoggerPtr.
#define DEBUG_M(logger, str) IMR_LOG_(*(logger), ::imr::LogLevel::kDebug, str)
#define INFO_M(logger, str) IMR_LOG_(*(logger), ::imr::LogLevel::kInfo, str)
#define WARN_M(logger, str) IMR_LOG_(*(logger), ::imr::LogLevel::kWarn, str)
#define ERROR_M(logger, str) IMR_LOG_(*(logger), ::imr::LogLevel::kError, str)

// Log an error and end the program with status -2 if the pointer is null.
#define MEM_CHECK(ptr, logger)                       \
  do {                                               \
    if (!(ptr)) {                                    \
      ERROR_M(logger, "out of memory for " << #ptr); \
      std::exit(-2);                                 \
    }                                                \
  } while (false)
#define PTR_CHECK(ptr, logger)             \
  do {                                     \
    if (!(ptr)) {                          \
      ERROR_M(logger, #ptr << " is null"); \
      std::exit(-2);                       \
    }                                      \
  } while (false)
