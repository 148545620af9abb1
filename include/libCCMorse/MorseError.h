#pragma once

#include <exception>
#include <ostream>
#include <string>
#include <utility>

#include "libplayerc++/playererror.h"

namespace CCMorse {

/// What every function of the library throws when it cannot do its work (thesis 3.1.1): a sentence
/// for people, the function it came from, and a code for programs. It is a PlayerError, whose
/// getters it has. A plain value: copying is safe, and so is reading it from several threads.
class MorseError : public std::exception, public PlayerCc::PlayerError {
 public:
  /// Code of an error that says that the simulation came to its planned end.
  static constexpr int kSimulationEnded = 1;
  /// Code of an error that says that the simulator refused a command or request; all else goes on.
  static constexpr int kRefused = 2;
  /// Code of an error that says that a later request took the place of this one.
  static constexpr int kPreempted = 3;

  /// `str`: what happened and where; `fun`: the function, as "Class::Method()"; `code`: -1 when
  /// nothing more is known (as in Player), else one of the above.
  explicit MorseError(const std::string& str = "", const std::string& fun = "", int code = -1)
      : PlayerError(fun, str, code), what_(fun + ": " + str) {}

  /// True when the run is over as planned: a program may take this as its regular end.
  bool SimulationEnded() const { return GetErrorCode() == kSimulationEnded; }

  /// Function and sentence in one line, for programs that catch std::exception.
  const char* what() const noexcept override { return what_.c_str(); }

 private:
  std::string what_;
};

/// Prints "fun(code) : text", as Player prints its PlayerError.
inline std::ostream& operator<<(std::ostream& out, const MorseError& error) {
  return out << error.GetErrorFun() << "(" << error.GetErrorCode() << ") : " << error.GetErrorStr();
}

}  // namespace CCMorse
