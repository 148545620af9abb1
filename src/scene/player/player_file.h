#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace ccmorse::scene {

/// Where something stands in a file.
struct FilePlace {
  std::string file;
  int line = 0;  ///< from 1

  std::string Text() const { return file + ":" + std::to_string(line); }
  /// Throws Error "FILE:LINE: text".
  [[noreturn]] void Fail(const std::string& text) const;
};

/// Something a file asks for that CCMorse does otherwise or not at all; never dropped in silence.
struct FileNote {
  FilePlace at;
  std::string text;
  /// The run differs from what the file asks for; else it is about a window or a speed-up that
  /// Player and Stage have and CCMorse needs not.
  bool matters = true;
};

/// A value as written: nothing is converted yet.
struct PlayerValue {
  enum class Kind { kNumber, kText, kTuple };
  Kind kind = Kind::kNumber;
  double number = 0.0;             ///< finite
  std::string text;                ///< of a string, or of the words yes, no, true and false
  std::vector<PlayerValue> items;  ///< of a tuple: numbers and strings
  FilePlace at;
};

/// A name and its value; the name of one with an index has it in itself: "point[3]".
struct PlayerProperty {
  std::string name;
  PlayerValue value;
};

/// A section of a .cfg, or a model of a .world.
struct PlayerEntity {
  std::string type;     ///< "driver", "position", ...; what a macro stands for
  std::string written;  ///< as the file has it: the type or the name of a macro
  FilePlace at;
  std::vector<PlayerProperty> properties;  ///< in order; of two alike the later counts
  std::vector<PlayerEntity> children;
};

/// A file of the language that Player's .cfg and Stage's .world files share (specs: player.md C.1),
/// with what it includes read and its macros replaced.
struct PlayerFile {
  PlayerEntity global;       ///< what stands outside of all entities, as properties and children
  double length_unit = 1.0;  ///< m in a length of the file: unit_length
  double angle_unit = 0.0;   ///< rad in an angle of the file: unit_angle, degrees by default
};

/// Which of the two languages: in a .cfg words may have colons.
enum class PlayerDialect { kConfig, kWorld };

/// How included files are read: gets a path, gives the content or throws Error.
using FileReader = std::function<std::string(const std::string& path)>;

/// Parses `text`, which is called `file` in messages; files that it includes start from the folder
/// of `file`, also where one included file includes another. Throws Error "FILE:LINE: ..." on what
/// is no such file: on characters, numbers and forms that the language has not, on a macro that is
/// defined by itself, on a cycle of includes, and on more than 200,000 entities, properties and
/// values or nesting deeper than 64.
PlayerFile ParsePlayerFile(const std::string& text, const std::string& file, PlayerDialect dialect,
                           const FileReader& read = ReadFile);

/// Looks the properties of an entity up by name and type, in m and rad; remembers which were asked
/// for. Refers to the entity and the file, which outlive it. Throws Error "FILE:LINE: ..." where a
/// value is of another type.
class PropertyReader {
 public:
  PropertyReader(const PlayerEntity& entity, const PlayerFile& file);

  const PlayerEntity& entity() const { return entity_; }
  const PlayerFile& file() const { return file_; }

  /// The value; nullptr where there is none. Counts as asked for.
  const PlayerValue* Find(std::string_view name);
  bool Has(std::string_view name) { return Find(name) != nullptr; }
  /// Where the property stands; where the entity does, if it has none.
  FilePlace At(std::string_view name);

  // The value, or `fallback` when there is none.
  double Number(std::string_view name, double fallback);
  int Integer(std::string_view name, int fallback);       ///< a whole number of +-1e9
  double Length(std::string_view name, double fallback);  ///< m
  double Angle(std::string_view name, double fallback);   ///< rad
  std::string Text(std::string_view name, const std::string& fallback);
  /// 1, 0, or yes, no, true, false as a word or a string.
  bool Bool(std::string_view name, bool fallback);
  /// The numbers of a tuple, at least `least` and at most units.size() of them, by letter: l in m,
  /// a in rad, f as written. Empty when there is none.
  std::vector<double> Tuple(std::string_view name, std::string_view units, std::size_t least);
  /// The strings of a tuple, or the only string.
  std::vector<std::string> Texts(std::string_view name);

  /// Properties that nobody asked for, each name once, in order.
  std::vector<const PlayerProperty*> Unused() const;

 private:
  const PlayerEntity& entity_;
  const PlayerFile& file_;
  std::vector<bool> asked_;
};

}  // namespace ccmorse::scene
