#pragma once

#include <exception>
#include <ostream>
#include <string>
#include <utility>

namespace CCMorse {

/// What every function of the library throws when it cannot do its work (thesis 3.1.1): a sentence
/// for people, the function it came from, and a code for programs. It has the same getters as
/// Player's PlayerError. A plain value: copying is safe, and so is reading it from several threads.
class MorseError : public std::exception {
 public:
  /// Code of an error that says that the simulation came to its planned end.
  static constexpr int kSimulationEnded = 1;
  /// Code of an error that says that the simulator refused a command or request; all else goes on.
  static constexpr int kRefused = 2;
  /// Code of an error that says that a later request took the place of this one.
  static constexpr int kPreempted = 3;

  /// `str`: what happened and where; `fun`: the function, as "Class::Method()"; `code`: -1 when
  /// nothing more is known (as in Player), else one of the above.
  explicit MorseError(std::string str = "", std::string fun = "", int code = -1)
      : str_(std::move(str)), fun_(std::move(fun)), code_(code), what_(fun_ + ": " + str_) {}

  /// What happened, one sentence (thesis listing C.2, line 101).
  std::string GetErrorStr() const { return str_; }
  /// The function that failed, as "MorseClient::Read()" (thesis listing C.2, line 102).
  std::string GetErrorFun() const { return fun_; }
  /// -1 unless something more is known, as in Player's PlayerError.
  int GetErrorCode() const { return code_; }
  /// True when the run is over as planned: a program may take this as its regular end.
  bool SimulationEnded() const { return code_ == kSimulationEnded; }

  /// Function and sentence in one line, for programs that catch std::exception.
  const char* what() const noexcept override { return what_.c_str(); }

 private:
  std::string str_;
  std::string fun_;
  int code_;
  std::string what_;
};

/// Prints "fun(code) : text", as Player prints its PlayerError.
inline std::ostream& operator<<(std::ostream& out, const MorseError& error) {
  return out << error.GetErrorFun() << "(" << error.GetErrorCode() << ") : " << error.GetErrorStr();
}

}  // namespace CCMorse
