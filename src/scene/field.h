#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "base/json.h"
#include "base/pose.h"

namespace ccmorse::scene {

/// Limits of a number in a file, both ends allowed unless `above_min`.
struct Range {
  double min = 0.0;
  double max = 0.0;
  bool above_min = false;  ///< the number must be greater than min
};

/// A value of a JSON file together with where it stands, so that every complaint about it reads
/// "FILE:LINE: robots[0].pose.x must be a number, not a string". All readers throw ccmorse::Error.
/// Refers to the value and the file name that it was made with: both must outlive it.
class Field {
 public:
  /// `path` is how a message calls the value, "" for the file's outermost one.
  Field(const Json& value, std::string path, const std::string& file)
      : value_(&value), path_(std::move(path)), file_(&file) {}

  const Json& value() const { return *value_; }
  const std::string& path() const { return path_; }
  const std::string& file() const { return *file_; }
  int line() const { return value_->line(); }

  double Number(const Range& range) const;
  /// A whole number; 3.0 is one, too.
  std::int64_t Integer(std::int64_t min, std::int64_t max) const;
  bool Bool() const;
  const std::string& Text() const;
  /// One of `choices`; the message names them all.
  std::string Choice(std::span<const std::string> choices) const;
  /// Letters, digits and _, 1 to 64 of them: what can stand in a MORSE component name.
  std::string Identifier() const;
  /// "#rrggbb", [r, g, b] of 0..255, or one of the course's colour names (specs: syrotek.md C).
  Color ReadColor() const;
  /// [x, y, z], each within +-limit.
  Vec3 Vector(double limit) const;
  /// The items of a list, each with its own path: "robots[0]".
  std::vector<Field> Items() const;

  /// Throws Error "FILE:LINE: text".
  [[noreturn]] void Fail(const std::string& text) const;
  /// The same with the field's path in front: "canvas.alpha must be ...".
  [[noreturn]] void FailHere(const std::string& text) const;

 private:
  const Json* value_;
  std::string path_;
  const std::string* file_;
};

/// Looks the members of a JSON object up by name and type, and remembers which names were asked
/// for; Finish() then reports whatever else the file has, so no misspelt key is silently dropped.
/// Throws Error on construction when the value is no object or has a key twice.
class ObjectReader {
 public:
  explicit ObjectReader(Field object);

  /// Is the key there? Counts as asked for.
  bool Has(const std::string& key);
  /// The member; throws Error when it is missing, naming the likely misspelling.
  Field Require(const std::string& key);

  // The member, or `fallback` when the object has none.
  double Number(const std::string& key, double fallback, const Range& range);
  int Integer(const std::string& key, int fallback, int min, int max);
  bool Bool(const std::string& key, bool fallback);
  std::string Choice(const std::string& key, const std::string& fallback,
                     std::span<const std::string> choices);
  Color ReadColor(const std::string& key, Color fallback);
  Vec3 Vector(const std::string& key, Vec3 fallback, double limit);
  /// An angle, rad, given as `key` in radians or `key`_deg in degrees; both is an error.
  double Angle(const std::string& key, double fallback);

  const Field& field() const { return object_; }

  /// Throws Error for the first key that was never asked for, with the nearest of those that were.
  void Finish() const;

 private:
  const Json* Find(const std::string& key);

  Field object_;
  std::set<std::string> asked_;
};

/// The text for a message: on one line, cut where it is long.
std::string Printable(std::string_view text);

/// 'text' for a message: in quotes, on one line, cut where it is long.
std::string Quoted(std::string_view text);

/// "a, b and c"
std::string Listed(std::span<const std::string> names);

/// "#rrggbb", as Field::ReadColor reads it.
std::string ColorText(Color color);

}  // namespace ccmorse::scene
