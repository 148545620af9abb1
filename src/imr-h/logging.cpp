#include "imr-h/logging.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>

#include "imr-h/imr_exceptions.h"
#include "imr-h/trimmed.h"

namespace imr {
namespace {

const char* prefixOf(LogLevel level) {
  switch (level) {
    case LogLevel::kDebug:
      return "DEBUG: ";
    case LogLevel::kInfo:
      return "INFO: ";
    case LogLevel::kWarn:
      return "WARN: ";
    case LogLevel::kError:
    case LogLevel::kOff:
      break;
  }
  return "ERROR: ";
}

void writeLine(const std::string& line);

// The three objects below are never destroyed: other threads, and destructors of static objects,
// may still log while the program ends.
std::mutex& outputMutex() {
  static std::mutex& mutex = *new std::mutex;
  return mutex;
}

struct Loggers {
  std::mutex mutex;
  std::map<std::string, std::unique_ptr<CLogger>> byName;
};

Loggers& loggers() {
  static Loggers& all = *new Loggers;
  return all;
}

LogLevel levelFromEnvironment() {
  const char* text = std::getenv("IMR_LOG");
  if (text == nullptr || *text == '\0') return LogLevel::kDebug;
  try {
    return logLevelFromText(text);
  } catch (const bad_usage& e) {
    writeLine(std::string("WARN: environment variable IMR_LOG: ") + e.what() + "\n");
    return LogLevel::kDebug;
  }
}

std::atomic<LogLevel>& currentLevel() {
  static std::atomic<LogLevel>& level = *new std::atomic<LogLevel>(levelFromEnvironment());
  return level;
}

void writeLine(const std::string& line) {
  const std::lock_guard<std::mutex> lock(outputMutex());
  std::cout.write(line.data(), static_cast<std::streamsize>(line.size()));
  std::cout.flush();
}

}  // namespace

namespace detail {

const CLogger& plainLogger() {
  static const CLogger& plain = *getLogger("");
  return plain;
}

}  // namespace detail

CLoggerPtr logger = getLogger("");

void CLogger::write(LogLevel level, const std::string& text) const {
  std::string line = prefixOf(level);
  if (!name_.empty()) line += name_ + ": ";
  line += text;
  line += '\n';
  writeLine(line);
}

CLoggerPtr getLogger(const std::string& name) {
  Loggers& all = loggers();
  const std::lock_guard<std::mutex> lock(all.mutex);
  std::unique_ptr<CLogger>& entry = all.byName[name];
  if (!entry) entry = std::make_unique<CLogger>(name);
  return entry.get();
}

void initLogger(const std::string& name) { logger = getLogger(name); }

void initLogger(const std::string& name, const std::string& configFile) {
  std::ifstream in(configFile);
  assert_io(in.is_open(), "cannot read the logger's configuration \"" + configFile + "\"");
  for (std::string line; std::getline(in, line);) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    const std::string key = trimmed(line.substr(0, equals));
    if (key != "log4j.rootLogger" && key != "log4j.rootCategory") continue;
    // "INFO, A1": the level, then the names of outputs.
    const std::string value = line.substr(equals + 1);
    setLogLevel(logLevelFromText(trimmed(value.substr(0, value.find(',')))));
  }
  initLogger(name);
}

void shutdownLogger() {
  const std::lock_guard<std::mutex> lock(outputMutex());
  std::cout.flush();
}

void setLogLevel(LogLevel level) { currentLevel().store(level, std::memory_order_relaxed); }

LogLevel getLogLevel() { return currentLevel().load(std::memory_order_relaxed); }

LogLevel logLevelFromText(const std::string& text) {
  std::string lower = text;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (lower == "debug") return LogLevel::kDebug;
  if (lower == "info") return LogLevel::kInfo;
  if (lower == "warn") return LogLevel::kWarn;
  if (lower == "error") return LogLevel::kError;
  if (lower == "off") return LogLevel::kOff;
  throw bad_usage("unknown log level \"" + text + "\" (known: debug, info, warn, error, off)");
}

bool isLogged(LogLevel level) { return level >= getLogLevel(); }

void warn(const std::string& text) { WARN(text); }

void error(const std::string& text) { ERROR(text); }

}  // namespace imr
