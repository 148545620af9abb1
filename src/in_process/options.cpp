#include "in_process/options.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"
#include "scene/field.h"

namespace ccmorse::in_process {
namespace {

[[noreturn]] void Refuse(std::string_view option, std::string_view value,
                         const std::string& wanted) {
  throw Error("sim: option " + std::string(option) + " is " + scene::Quoted(value) + ", must be " +
              wanted);
}

// "a%20b" -> "a b" (RFC 3986, 2.1).
std::string Decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    unsigned value = 0;
    const char* const first = text.data() + i + 1;
    const char* const last = text.data() + std::min(i + 3, text.size());
    const auto read = std::from_chars(first, last, value, 16);
    if (read.ptr != first + 2 || value == 0) {
      throw Error("sim: '%' in " + scene::Quoted(text) + " begins no %XX; write %25 for itself");
    }
    decoded += static_cast<char>(value);
    i += 2;
  }
  return decoded;
}

double Number(std::string_view option, std::string_view text, double most) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end || !(value > 0.0) || value > most) {
    Refuse(option, text, "a number above 0, at most " + std::to_string(std::lround(most)));
  }
  return value;
}

std::int64_t Whole(std::string_view option, std::string_view text, std::int64_t least,
                   std::int64_t most) {
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end || value < least || value > most) {
    Refuse(option, text,
           "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return value;
}

servers::Pace ToPace(std::string_view text) {
  if (text == "real") return servers::Pace::kRealTime;
  if (text == "lockstep") return servers::Pace::kLockstep;
  if (text == "max") return servers::Pace::kMax;
  Refuse("pace", text, "real, lockstep or max");
}

LogLevel ToLogLevel(std::string_view text) {
  if (text == "off") return LogLevel::kOff;
  if (text == "error") return LogLevel::kError;
  if (text == "warning") return LogLevel::kWarning;
  if (text == "info") return LogLevel::kInfo;
  Refuse("log", text, "off, error, warning or info");
}

}  // namespace

Options ParseOptions(std::string_view text) {
  Options options;
  using Take = std::function<void(const std::string&)>;
  constexpr double kMost = 1e9;
  const std::map<std::string, Take, std::less<>> takers = {
      {"pace", [&](const std::string& value) { options.pace = ToPace(value); }},
      {"factor", [&](const std::string& value) { options.factor = Number("factor", value, 1e6); }},
      {"seed",
       [&](const std::string& value) {
         options.seed = static_cast<std::uint64_t>(
             Whole("seed", value, 0, std::numeric_limits<std::int64_t>::max()));
       }},
      {"threads",
       [&](const std::string& value) {
         options.threads = static_cast<int>(Whole("threads", value, 1, 256));
       }},
      {"for", [&](const std::string& value) { options.seconds = Number("for", value, kMost); }},
      {"clients",
       [&](const std::string& value) {
         options.clients = static_cast<int>(Whole("clients", value, 1, 256));
       }},
      {"out", [&](const std::string& value) { options.out = value; }},
      {"record", [&](const std::string& value) { options.record = value; }},
      {"report", [&](const std::string& value) { options.report = value; }},
      {"log", [&](const std::string& value) { options.log = ToLogLevel(value); }},
      {"name", [&](const std::string& value) { options.name = value; }},
  };

  const std::size_t mark = text.find('?');
  options.scenario = Decoded(text.substr(0, mark));
  if (options.scenario.empty()) {
    throw Error("sim: an address names a scenario, as in sim:syrotek?pace=lockstep");
  }
  std::string_view rest = mark == std::string_view::npos ? "" : text.substr(mark + 1);
  std::vector<std::string> seen;
  while (!rest.empty()) {
    const std::size_t end = rest.find('&');
    const std::string_view pair = rest.substr(0, end);
    rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
    if (pair.empty()) continue;
    const std::size_t equals = pair.find('=');
    const std::string key = Decoded(pair.substr(0, equals));
    const auto taker = takers.find(key);
    if (taker == takers.end()) {
      // Those of the client's own are said here, too, so that one message tells of all.
      std::vector<std::string> known = {"protocol", "robot"};
      for (const auto& [name, ignored] : takers) known.push_back(name);
      throw Error("sim: there is no option " + scene::Quoted(key) + DidYouMean(key, known) +
                  "; there are " + scene::Listed(known));
    }
    for (const std::string& before : seen) {
      if (before == key) throw Error("sim: option " + key + " is given twice");
    }
    seen.push_back(key);
    if (equals == std::string_view::npos || equals + 1 == pair.size()) {
      throw Error("sim: option " + key + " has no value");
    }
    taker->second(Decoded(pair.substr(equals + 1)));
  }
  return options;
}

}  // namespace ccmorse::in_process
