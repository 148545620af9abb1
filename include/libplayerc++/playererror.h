#pragma once

#include <iosfwd>
#include <string>

namespace PlayerCc {

/// What the library throws when it cannot do its work (specs: player.md A.4). Everything it throws
/// is one; CCMorse::MorseError derives from it. A plain value.
class PlayerError {
 public:
  /// `fun`: "Class::Method()"; `str`: what happened; `code`: -1 when nothing more is known.
  // NOLINTNEXTLINE(google-explicit-constructor): Player's own
  PlayerError(const std::string& fun = "", const std::string& str = "", int code = -1)
      : str_(str), fun_(fun), code_(code) {}
  virtual ~PlayerError() = default;
  PlayerError(const PlayerError& other) = default;
  PlayerError& operator=(const PlayerError& other) = default;

  std::string GetErrorStr() const { return str_; }  ///< what happened, one sentence
  std::string GetErrorFun() const { return fun_; }  ///< the function that failed
  int GetErrorCode() const { return code_; }        ///< -1 unless something more is known

 private:
  std::string str_;
  std::string fun_;
  int code_;
};

}  // namespace PlayerCc

namespace std {
/// Prints "fun(code) : text".
ostream& operator<<(ostream& out, const PlayerCc::PlayerError& error);
}  // namespace std
