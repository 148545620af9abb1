#pragma once

#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"

namespace ccmorse::sim {

/// How a service ended, in MORSE's terms (specs: morse.md A.5).
enum class Outcome { kSuccess, kFailed, kPreempted };

struct ServiceResult {
  Outcome outcome = Outcome::kSuccess;
  Json value;                  ///< the result; for kFailed the text
  std::string_view text = {};  ///< the result as JSON, instead of `value`; valid during the call
};

/// Called once, when an asynchronous service ends.
using Completion = std::function<void(ServiceResult)>;

/// The caller's fault: answered FAILED with exactly this text.
class ServiceFailed : public std::runtime_error {
 public:
  explicit ServiceFailed(const std::string& text) : std::runtime_error(text) {}
};

/// An argument of the wrong type or out of range: answered FAILED
/// "Socket service manager: wrong parameter type for service NAME. <text>".
class WrongArgument : public std::runtime_error {
 public:
  explicit WrongArgument(const std::string& text) : std::runtime_error(text) {}
};

using Arguments = std::span<const Json>;

struct ServiceParameter {
  std::string name;
  bool optional = false;
};

/// What becomes of a call of an asynchronous service while one of the same component runs (specs:
/// morse.md A.5). It is the running one that decides.
enum class WhileRunning {
  /// The component ends the running one as PREEMPTED, and starts the new one (@interruptible).
  kPreempts,
  /// "A service (...) is already running. I do not know what to do." (MORSE's, where none is said.)
  kRefused,
  /// "A non-interruptible service (...) is already running" (@noninterruptible).
  kNeverPreempted,
};

/// Something a component does on request; exactly one of the first three functions is set.
struct Service {
  std::string name;
  std::vector<ServiceParameter> parameters;
  std::function<Json(Arguments)> run;                     ///< answers at once
  std::function<void(Arguments, Completion)> start = {};  ///< answers later
  std::function<const std::string&()> text = {};          ///< answers at once, ready-made JSON
  /// The same for arguments that come as bytes, in a form that the service defines; where it is
  /// there, it is much faster than `run` on many numbers. May throw as `run` may.
  std::function<void(std::string_view)> bytes = {};
  /// False: a question, or a matter of the run around the simulation (its pace, its log, a file).
  /// Calls of all others go into the run's record, so true is what is safe.
  bool changes_simulation = true;
  /// Of an asynchronous one: whoever calls services sees to the last two; for the first the
  /// component itself calls the old Completion before it keeps the new one.
  WhileRunning while_running = WhileRunning::kPreempts;
};

// Typed access to arguments. Each throws WrongArgument that names the parameter.

/// A finite number.
double NumberArgument(Arguments arguments, std::size_t index, const char* name);
/// The same, or `fallback` where the argument was left out.
double NumberArgument(Arguments arguments, std::size_t index, const char* name, double fallback);
/// A whole number in [low, high].
int IntegerArgument(Arguments arguments, std::size_t index, const char* name, int low, int high);
const std::string& StringArgument(Arguments arguments, std::size_t index, const char* name);

/// A finite number as member `key` of a message. Throws WrongArgument that names the key.
double NumberMember(const Json& object, const char* key);

}  // namespace ccmorse::sim
