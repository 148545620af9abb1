#pragma once

#include <deque>
#include <iosfwd>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "imr-h/imr_exceptions.h"

namespace imr {

/// The options of a program: each has a name, a type, a description, maybe a default, and a value
/// (thesis C.2 l.16-39).
///
/// A class that needs options registers them in a static `CConfig& getConfig(CConfig&)`; main()
/// calls these functions, reads the command line (imr-h/args_config.h) and hands the store on.
/// Options may be of type std::string, int, double, float and bool; another type does not compile.
///
/// Errors: every function that takes a name throws imr::bad_usage when no option has that name, or
/// when the option is not of type T; the message names the option, the nearest one and all known
/// ones. Thread safety: several threads may read; adding and setting need a lock of the caller's.
/// References and pointers to values stay good as long as the store lives.
class CConfig {
 public:
  /// The type of an option, in the order in which Value below lists the C++ types.
  enum TType { STRING, INT, DOUBLE, FLOAT, BOOL, NUM_TYPES };

  /// One entry of the iteration over all options.
  struct SItem {
    std::string name;  ///< As given to add().
    TType type;        ///< Type of the value.
  };

  typedef std::vector<std::string> NameList;
  typedef std::vector<SItem> ItemList;
  typedef ItemList::const_iterator const_iterator;

  /// Adds an option without a default; its value is empty, zero or false until it is set.
  /// Throws bad_usage if the name is taken or empty.
  template <typename T>
  void add(const std::string& name, const std::string& description = "") {
    addOption(name, description, Value(T()), false);
  }

  /// Adds an option whose value is `defaultValue` until it is set (thesis C.2 l.19-38).
  /// Throws bad_usage if the name is taken or empty.
  template <typename T>
  void add(const std::string& name, const std::string& description, const T& defaultValue) {
    addOption(name, description, Value(defaultValue), true);
  }

  /// Sets the value of an option.
  template <typename T>
  void set(const std::string& name, const T& value) {
    valueOf<T>(name) = value;
  }

  /// The value of an option; assigning to the result sets it (thesis C.2 l.46).
  template <typename T>
  T& get(const std::string& name) {
    return valueOf<T>(name);
  }
  template <typename T>
  const T& get(const std::string& name) const {
    return std::get<T>(checked(name, typeOf<T>()).value);
  }

  /// Where the value of an option is kept; never null.
  template <typename T>
  T* getPtr(const std::string& name) {
    return &valueOf<T>(name);
  }

  /// Whether the option was added with a default.
  template <typename T>
  bool hasDefaultValue(const std::string& name) const {
    return checked(name, typeOf<T>()).defaultValue.has_value();
  }

  /// The default of an option. Throws bad_usage also if it was added without one.
  template <typename T>
  const T& getDefaultValue(const std::string& name) const {
    const SOption& option = checked(name, typeOf<T>());
    if (!option.defaultValue) throw bad_usage("option \"" + name + "\" has no default value");
    return std::get<T>(*option.defaultValue);
  }

  /// The text that was given to add() for people to read.
  template <typename T>
  const std::string& getDescription(const std::string& name) const {
    return checked(name, typeOf<T>()).description;
  }

  /// Appends the names of all options of type T to `names`, in the order in which they were added.
  template <typename T>
  void getNames(NameList& names) const {
    for (const SItem& item : items_) {
      if (item.type == typeOf<T>()) names.push_back(item.name);
    }
  }

  /// All options in the order in which they were added.
  const_iterator items_begin() const { return items_.begin(); }
  const_iterator items_end() const { return items_.end(); }
  const_iterator begin() const { return items_.begin(); }
  const_iterator end() const { return items_.end(); }

  /// Whether an option of that name, of any type, was added.
  bool has(const std::string& name) const;

  /// The type of an option. Throws bad_usage if there is none of that name.
  TType getType(const std::string& name) const;

  /// The value of an option of any type as text, as print() writes it: a bool is "true" or "false",
  /// a number the shortest text that reads back as the same number.
  std::string getText(const std::string& name) const;

  /// The default of an option of any type as text; empty if there is none.
  std::string getDefaultText(const std::string& name) const;

  /// The description of an option of any type.
  const std::string& getDescriptionText(const std::string& name) const;

  /// Sets an option of any type from text. A number must be finite and fill the whole text; a bool
  /// is one of true false yes no on off 1 0. Throws bad_usage, with the text, if it does not fit;
  /// the old value stays then.
  void setText(const std::string& name, const std::string& text);

  /// Throws as setText() would, and sets nothing.
  void checkText(const std::string& name, const std::string& text) const;

  /// Writes a line "name=value" for every option, in the order in which they were added.
  void print(std::ostream& out) const;

 private:
  typedef std::variant<std::string, int, double, float, bool> Value;

  struct SOption {
    std::string name;
    std::string description;
    Value value;
    std::optional<Value> defaultValue;
  };

  template <typename T>
  static constexpr TType typeOf() {
    static_assert(std::is_same_v<T, std::string> || std::is_same_v<T, int> ||
                      std::is_same_v<T, double> || std::is_same_v<T, float> ||
                      std::is_same_v<T, bool>,
                  "an option is a std::string, an int, a double, a float or a bool");
    if (std::is_same_v<T, std::string>) return STRING;
    if (std::is_same_v<T, int>) return INT;
    if (std::is_same_v<T, double>) return DOUBLE;
    if (std::is_same_v<T, float>) return FLOAT;
    return BOOL;
  }

  template <typename T>
  T& valueOf(const std::string& name) {
    return std::get<T>(const_cast<SOption&>(checked(name, typeOf<T>())).value);
  }

  void addOption(const std::string& name, const std::string& description, Value value,
                 bool hasDefault);
  const SOption& checked(const std::string& name, TType type) const;  // also checks the type
  const SOption& find(const std::string& name) const;                 // any type
  Value parse(const SOption& option, const std::string& text) const;

  std::deque<SOption> options_;  // a deque: growing it moves no value
  ItemList items_;
};

}  // namespace imr
