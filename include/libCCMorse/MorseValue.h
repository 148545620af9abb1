#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace ccmorse {
class Json;
}

namespace CCMorse {

/// A value that a simulator sent: a number, a text, a list or an object of named values
/// (thesis 3.3). It is read-only and shares its storage with its copies, so copying is cheap, it
/// may outlive the connection, and several threads may read it.
///
/// A path names a value inside it: keys of objects and positions in lists joined by dots, as in
/// "color.0" or "pose.yaw"; the empty path is the value itself. Getters give the fallback when the
/// path leads nowhere or to a value of another type; they never throw.
class MorseValue {
 public:
  /// The null value: what a service without a result answers.
  MorseValue();

  /// Parses JSON, bare NaN and Infinity included. Throws MorseError that says where the text is
  /// wrong.
  static MorseValue Parse(const std::string& text);

  bool IsNull() const;    ///< no value
  bool IsNumber() const;  ///< an integer or a decimal number
  bool IsString() const;
  bool IsList() const;
  bool IsObject() const;
  /// What Python calls true: not null, false, 0, an empty text, list or object.
  bool IsTrue() const;

  /// Whether `path` leads to a value, null included.
  bool Has(const std::string& path) const;
  /// The value at `path`; null where it leads nowhere.
  MorseValue Get(const std::string& path) const;

  double GetDouble(const std::string& path, double fallback = 0.0) const;
  /// Decimal numbers are cut towards zero and held within int's range.
  int GetInt(const std::string& path, int fallback = 0) const;
  bool GetBool(const std::string& path, bool fallback = false) const;
  std::string GetString(const std::string& path, const std::string& fallback = "") const;
  /// A list of numbers; empty when it is missing or anything in it is no number.
  std::vector<double> GetDoubles(const std::string& path) const;
  /// A list of texts; empty when it is missing or anything in it is no text.
  std::vector<std::string> GetStrings(const std::string& path) const;
  /// The keys of the object at `path`, in the order in which they were sent.
  std::vector<std::string> GetKeys(const std::string& path = "") const;
  /// How many elements the list or object at `path` has; 0 for anything else.
  std::size_t GetSize(const std::string& path = "") const;
  /// Element `index` of a list; null beyond its end.
  MorseValue At(std::size_t index) const;
  /// Member `key` of an object, the key taken literally (dots included); null when missing.
  MorseValue Member(const std::string& key) const;

  /// The value as JSON in one line.
  std::string ToString() const;

 private:
  MorseValue(std::shared_ptr<const ccmorse::Json> root, const ccmorse::Json* node);
  const ccmorse::Json* Find(const std::string& path) const;

  std::shared_ptr<const ccmorse::Json> root_;  // keeps node_ alive
  const ccmorse::Json* node_ = nullptr;        // nullptr is the null value
};

/// The arguments of a service, in order, written as the protocol wants them:
/// `MorseArgs(0.3, 0.0)` is `[0.3, 0.0]`. A plain value.
class MorseArgs {
 public:
  /// No arguments.
  MorseArgs() = default;

  /// Numbers, truth values, texts, other MorseArgs (as nested lists), in order.
  template <class First, class... Rest,
            class = std::enable_if_t<!std::is_same_v<std::decay_t<First>, MorseArgs> ||
                                     (sizeof...(Rest) > 0)>>
  explicit MorseArgs(const First& first, const Rest&... rest) {
    Add(first);
    (Add(rest), ...);
  }

  MorseArgs& Add(bool value);
  MorseArgs& Add(int value);
  MorseArgs& Add(double value);
  MorseArgs& Add(const char* value);
  MorseArgs& Add(const std::string& value);
  /// A nested list.
  MorseArgs& Add(const MorseArgs& list);
  /// Any value, such as an object; null where it is none.
  MorseArgs& Add(const MorseValue& value);

  /// "" without arguments, else the JSON list.
  std::string ToString() const;
  /// The JSON list, "[]" when there is nothing in it.
  std::string ToList() const { return "[" + items_ + "]"; }

 private:
  void Separate();
  std::string items_;  // what stands between the brackets
};

}  // namespace CCMorse
