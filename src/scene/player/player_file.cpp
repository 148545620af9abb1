#include "scene/player/player_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "base/trig.h"
#include "scene/field.h"

namespace ccmorse::scene {
namespace {

constexpr int kMostParts = 200000;  // entities, properties and values, macros replaced
constexpr int kDeepest = 64;
constexpr int kMostIncludes = 1000;
constexpr std::size_t kLongestString = 255;

enum class TokenKind { kWord, kNumber, kText, kOpen, kClose, kOpenTuple, kCloseTuple, kEnd };

struct Token {
  TokenKind kind = TokenKind::kEnd;
  std::string text;
  double number = 0.0;
  int line = 0;
};

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsNumberPart(char c) { return IsDigit(c) || c == '+' || c == '-' || c == '.'; }

// Takes a text apart into tokens (specs: player.md C.1).
class Lexer {
 public:
  Lexer(std::string_view text, const std::string& file, PlayerDialect dialect)
      : text_(text), file_(file), dialect_(dialect) {
    Next();
  }

  const Token& token() const { return token_; }
  FilePlace Place() const { return {file_, token_.line}; }

  void Next() {
    SkipBlanks();
    token_ = {TokenKind::kEnd, "", 0.0, line_};
    if (at_ == text_.size()) return;
    const char c = text_[at_];
    if (IsLetter(c)) {
      Word();
    } else if (IsNumberPart(c)) {
      Number();
    } else if (c == '"') {
      Text();
    } else {
      Mark(c);
    }
  }

 private:
  void SkipBlanks() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
        continue;
      }
      if (c != ' ' && c != '\t' && c != '\r' && c != '\n') return;
      if (c == '\n') ++line_;
      ++at_;
    }
  }

  // "point[3]" is one word, and "size[1 2]" is a word and a tuple: a bracket belongs to the word
  // only with an index and its end.
  bool IsIndex() const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && IsDigit(text_[end])) ++end;
    if (end == at_ + 1 || end == text_.size() || text_[end] != ']') return false;
    // "size[3]" with nothing but an index is one, too; a tuple of one number needs a blank before.
    return true;
  }

  void Word() {
    const std::size_t begin = at_;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '[') {
        if (!IsIndex()) break;
        while (text_[at_] != ']') ++at_;
        ++at_;
        continue;
      }
      const bool part = IsLetter(c) || IsDigit(c) || c == '.' || c == '-' || c == '_' ||
                        (c == ':' && dialect_ == PlayerDialect::kConfig);
      if (!part) break;
      ++at_;
    }
    token_.kind = TokenKind::kWord;
    token_.text = text_.substr(begin, at_ - begin);
  }

  void Number() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && IsNumberPart(text_[at_])) ++at_;
    const std::string_view all = text_.substr(begin, at_ - begin);
    const std::string_view digits = all.front() == '+' ? all.substr(1) : all;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), token_.number);
    // "+-1" must not pass as "-1" once the plus is taken off.
    if (read.ec != std::errc{} || read.ptr != digits.data() + digits.size() ||
        (all.front() == '+' && digits.front() == '-')) {
      Place().Fail(fmt::format("{} is no number", Quoted(all)));
    }
    if (at_ < text_.size() && (IsLetter(text_[at_]) || text_[at_] == '_')) {
      Place().Fail(fmt::format("{} is followed by '{}'; numbers have no exponent and no unit here",
                               Quoted(all), text_[at_]));
    }
    token_.kind = TokenKind::kNumber;
    token_.text = all;
  }

  void Text() {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\n') ++at_;
    if (at_ == text_.size() || text_[at_] == '\n') {
      Place().Fail("a string begins here that does not end on its line; add the closing \"");
    }
    token_.kind = TokenKind::kText;
    token_.text = text_.substr(begin, at_ - begin);
    ++at_;
    if (token_.text.size() > kLongestString) {
      Place().Fail(fmt::format("a string of {} characters, must be at most {}", token_.text.size(),
                               kLongestString));
    }
    if (std::any_of(token_.text.begin(), token_.text.end(),
                    [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; })) {
      Place().Fail("a string with a control character in it; remove it");
    }
  }

  void Mark(char c) {
    switch (c) {
      case '(':
        token_.kind = TokenKind::kOpen;
        break;
      case ')':
        token_.kind = TokenKind::kClose;
        break;
      case '[':
        token_.kind = TokenKind::kOpenTuple;
        break;
      case ']':
        token_.kind = TokenKind::kCloseTuple;
        break;
      default:
        Place().Fail(
            fmt::format("{} has no meaning here; there are words, numbers, \"strings\", ( ), [ ] "
                        "and # comments",
                        static_cast<unsigned char>(c) < 0x80 ? Quoted(std::string_view(&c, 1))
                                                             : "a letter that is not ASCII"));
    }
    token_.text = std::string(1, c);
    ++at_;
  }

  std::string_view text_;
  const std::string& file_;
  PlayerDialect dialect_;
  std::size_t at_ = 0;
  int line_ = 1;
  Token token_;
};

class Parser {
 public:
  Parser(const std::string& file, PlayerDialect dialect, const FileReader& read)
      : folder_(std::filesystem::path(file).parent_path()), dialect_(dialect), read_(read) {
    global_.at = {file, 1};
  }

  void ParseText(const std::string& text, const std::string& file) {
    open_.push_back(file);
    Lexer lexer(text, file, dialect_);
    while (lexer.token().kind != TokenKind::kEnd) {
      const Token token = lexer.token();
      const FilePlace at = lexer.Place();
      if (token.kind != TokenKind::kWord) {
        at.Fail(fmt::format("{} where a name should stand", Quoted(token.text)));
      }
      lexer.Next();
      if (token.text == "include") {
        Include(lexer, at);
      } else if (token.text == "define") {
        Define(lexer);
      } else {
        Item(lexer, token.text, at, 1, global_);
      }
    }
    open_.pop_back();
  }

  PlayerEntity Take() { return std::move(global_); }

 private:
  void Include(Lexer& lexer, const FilePlace& at) {
    if (lexer.token().kind != TokenKind::kText) {
      at.Fail("include needs the name of a file: include \"pioneer.inc\"");
    }
    const std::string name = lexer.token().text;
    lexer.Next();
    const std::string path = (folder_ / name).lexically_normal().string();
    if (std::find(open_.begin(), open_.end(), path) != open_.end()) {
      at.Fail(fmt::format("{} includes itself; remove one of the includes", Quoted(path)));
    }
    if (++includes_ > kMostIncludes) {
      at.Fail(fmt::format("more than {} files are included", kMostIncludes));
    }
    std::string text;
    try {
      text = read_(path);
    } catch (const Error& error) {
      at.Fail(fmt::format("{}; names of included files start from the folder of the first file",
                          error.what()));
    }
    ParseText(text, path);
  }

  void Define(Lexer& lexer) {
    const FilePlace at = lexer.Place();
    const std::string name = Name(lexer, "define needs a name: define NAME TYPE ( ... )");
    const std::string type = Name(lexer, "define needs a type: define NAME TYPE ( ... )");
    if (name == type) {
      at.Fail(fmt::format("{} is defined by itself; give one of them another name", Quoted(name)));
    }
    PlayerEntity body = Instance(type, at);
    Expect(lexer, TokenKind::kOpen, "(");
    Body(lexer, 1, body);
    body.written = name;
    macros_[name] = std::move(body);
  }

  static std::string Name(Lexer& lexer, const char* what) {
    if (lexer.token().kind != TokenKind::kWord) lexer.Place().Fail(what);
    std::string name = lexer.token().text;
    lexer.Next();
    return name;
  }

  static void Expect(Lexer& lexer, TokenKind kind, const char* mark) {
    if (lexer.token().kind != kind) {
      lexer.Place().Fail(fmt::format(
          "{} where {} should stand",
          lexer.token().kind == TokenKind::kEnd ? "the file ends" : Quoted(lexer.token().text),
          mark));
    }
    lexer.Next();
  }

  // A new entity of the type: empty, or what a macro of that name holds so far.
  PlayerEntity Instance(const std::string& type, const FilePlace& at) {
    const auto macro = macros_.find(type);
    PlayerEntity entity;
    if (macro == macros_.end()) {
      entity.type = type;
    } else {
      Count(Parts(macro->second), at);
      entity = macro->second;
    }
    entity.written = type;
    entity.at = at;
    return entity;
  }

  static int Parts(const PlayerEntity& entity) {
    int parts = 1;
    for (const PlayerProperty& property : entity.properties) {
      parts += 1 + static_cast<int>(property.value.items.size());
    }
    for (const PlayerEntity& child : entity.children) parts += Parts(child);
    return parts;
  }

  void Count(int parts, const FilePlace& at) {
    parts_ += parts;
    if (parts_ > kMostParts) {
      at.Fail(
          fmt::format("more than {} entities, properties and values, macros replaced", kMostParts));
    }
  }

  // After "(": everything up to and with ")".
  void Body(Lexer& lexer, int depth, PlayerEntity& entity) {
    if (depth > kDeepest) {
      lexer.Place().Fail(fmt::format("entities are nested deeper than {}", kDeepest));
    }
    while (lexer.token().kind != TokenKind::kClose) {
      const FilePlace at = lexer.Place();
      if (lexer.token().kind == TokenKind::kEnd) {
        at.Fail(fmt::format("the file ends within the {} of line {}; add the closing )",
                            Quoted(entity.written), entity.at.line));
      }
      const std::string name =
          Name(lexer, "a name should stand here, of a property or an entity; or the closing )");
      if (name == "define" || name == "include") {
        at.Fail(fmt::format("{} must stand outside of all entities", Quoted(name)));
      }
      Item(lexer, name, at, depth + 1, entity);
    }
    lexer.Next();
  }

  // After a name: a property's value or an entity's "(".
  void Item(Lexer& lexer, const std::string& name, const FilePlace& at, int depth,
            PlayerEntity& parent) {
    Count(1, at);
    if (lexer.token().kind == TokenKind::kOpen) {
      PlayerEntity child = Instance(name, at);
      lexer.Next();
      Body(lexer, depth, child);
      parent.children.push_back(std::move(child));
      return;
    }
    parent.properties.push_back({name, Value(lexer, name, at)});
  }

  PlayerValue Value(Lexer& lexer, const std::string& name, const FilePlace& at) {
    PlayerValue value;
    value.at = at;
    const Token token = lexer.token();
    switch (token.kind) {
      case TokenKind::kNumber:
        value.number = token.number;
        break;
      case TokenKind::kText:
        value.kind = PlayerValue::Kind::kText;
        value.text = token.text;
        break;
      case TokenKind::kWord:
        // Not in the grammar, but public files say "usegui yes".
        if (token.text != "yes" && token.text != "no" && token.text != "true" &&
            token.text != "false") {
          at.Fail(
              fmt::format("{} is followed by {}, must be by a number, a \"string\", a tuple [ ] "
                          "or the ( ) of an entity",
                          Quoted(name), Quoted(token.text)));
        }
        value.kind = PlayerValue::Kind::kText;
        value.text = token.text;
        break;
      case TokenKind::kOpenTuple:
        Tuple(lexer, name, value);
        return value;
      default:
        at.Fail(
            fmt::format("{} has no value; add a number, a \"string\", a tuple [ ] or the ( ) of "
                        "an entity",
                        Quoted(name)));
    }
    lexer.Next();
    return value;
  }

  void Tuple(Lexer& lexer, const std::string& name, PlayerValue& value) {
    value.kind = PlayerValue::Kind::kTuple;
    const FilePlace begin = lexer.Place();
    lexer.Next();
    while (lexer.token().kind != TokenKind::kCloseTuple) {
      PlayerValue item;
      item.at = lexer.Place();
      Count(1, item.at);
      if (lexer.token().kind == TokenKind::kNumber) {
        item.number = lexer.token().number;
      } else if (lexer.token().kind == TokenKind::kText) {
        item.kind = PlayerValue::Kind::kText;
        item.text = lexer.token().text;
      } else if (lexer.token().kind == TokenKind::kEnd) {
        begin.Fail(fmt::format("the tuple of {} does not end; add the closing ]", Quoted(name)));
      } else {
        item.at.Fail(fmt::format("{} in the tuple of {}, which may hold numbers and \"strings\"",
                                 Quoted(lexer.token().text), Quoted(name)));
      }
      value.items.push_back(std::move(item));
      lexer.Next();
    }
    lexer.Next();
  }

  std::filesystem::path folder_;
  PlayerDialect dialect_;
  const FileReader& read_;
  PlayerEntity global_;
  std::map<std::string, PlayerEntity> macros_;
  std::vector<std::string> open_;  // files being read, the first one first
  int includes_ = 0;
  int parts_ = 0;
};

double UnitOf(PlayerEntity& global, const char* name, const std::map<std::string, double>& units,
              double fallback) {
  double unit = fallback;
  for (const PlayerProperty& property : global.properties) {
    if (property.name != name) continue;
    const auto found = property.value.kind == PlayerValue::Kind::kText
                           ? units.find(property.value.text)
                           : units.end();
    if (found == units.end()) {
      std::vector<std::string> known;
      for (const auto& entry : units) known.push_back("\"" + entry.first + "\"");
      property.value.at.Fail(fmt::format("{} must be one of {}", name, Listed(known)));
    }
    unit = found->second;
  }
  std::erase_if(global.properties, [name](const auto& property) { return property.name == name; });
  return unit;
}

const char* KindName(PlayerValue::Kind kind) {
  switch (kind) {
    case PlayerValue::Kind::kNumber:
      return "a number";
    case PlayerValue::Kind::kText:
      return "a string";
    default:
      return "a tuple";
  }
}

}  // namespace

void FilePlace::Fail(const std::string& text) const { throw Error(Text() + ": " + text); }

PlayerFile ParsePlayerFile(const std::string& text, const std::string& file, PlayerDialect dialect,
                           const FileReader& read) {
  // So that a file that includes itself is known by its name.
  const std::string name = std::filesystem::path(file).lexically_normal().string();
  Parser parser(name, dialect, read);
  parser.ParseText(text, name);
  PlayerFile parsed;
  parsed.global = parser.Take();
  parsed.length_unit =
      UnitOf(parsed.global, "unit_length", {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}}, 1.0);
  parsed.angle_unit = UnitOf(parsed.global, "unit_angle",
                             {{"degrees", Radians(1.0)}, {"radians", 1.0}}, Radians(1.0));
  return parsed;
}

PropertyReader::PropertyReader(const PlayerEntity& entity, const PlayerFile& file)
    : entity_(entity), file_(file), asked_(entity.properties.size(), false) {}

const PlayerValue* PropertyReader::Find(std::string_view name) {
  const PlayerValue* found = nullptr;
  for (std::size_t i = 0; i < entity_.properties.size(); ++i) {
    if (entity_.properties[i].name != name) continue;
    asked_[i] = true;
    found = &entity_.properties[i].value;
  }
  return found;
}

FilePlace PropertyReader::At(std::string_view name) {
  const PlayerValue* const value = Find(name);
  return value != nullptr ? value->at : entity_.at;
}

double PropertyReader::Number(std::string_view name, double fallback) {
  const PlayerValue* const value = Find(name);
  if (value == nullptr) return fallback;
  if (value->kind != PlayerValue::Kind::kNumber) {
    value->at.Fail(fmt::format("{} must be a number, not {}", name, KindName(value->kind)));
  }
  return value->number;
}

int PropertyReader::Integer(std::string_view name, int fallback) {
  const double number = Number(name, fallback);
  if (number != std::floor(number) || std::fabs(number) > 1e9) {
    At(name).Fail(fmt::format("{} must be a whole number, not {}", name, number));
  }
  return static_cast<int>(number);
}

double PropertyReader::Length(std::string_view name, double fallback) {
  return Has(name) ? Number(name, 0.0) * file_.length_unit : fallback;
}

double PropertyReader::Angle(std::string_view name, double fallback) {
  return Has(name) ? Number(name, 0.0) * file_.angle_unit : fallback;
}

std::string PropertyReader::Text(std::string_view name, const std::string& fallback) {
  const PlayerValue* const value = Find(name);
  if (value == nullptr) return fallback;
  if (value->kind != PlayerValue::Kind::kText) {
    value->at.Fail(fmt::format("{} must be a \"string\", not {}", name, KindName(value->kind)));
  }
  return value->text;
}

bool PropertyReader::Bool(std::string_view name, bool fallback) {
  const PlayerValue* const value = Find(name);
  if (value == nullptr) return fallback;
  if (value->kind == PlayerValue::Kind::kNumber) return value->number != 0.0;
  if (value->kind == PlayerValue::Kind::kText) {
    if (value->text == "yes" || value->text == "true" || value->text == "1") return true;
    if (value->text == "no" || value->text == "false" || value->text == "0") return false;
  }
  value->at.Fail(fmt::format("{} must be 1, 0, yes, no, true or false", name));
}

std::vector<double> PropertyReader::Tuple(std::string_view name, std::string_view units,
                                          std::size_t least) {
  const PlayerValue* const value = Find(name);
  if (value == nullptr) return {};
  if (value->kind != PlayerValue::Kind::kTuple) {
    value->at.Fail(fmt::format("{} must be a tuple [ ], not {}", name, KindName(value->kind)));
  }
  if (value->items.size() < least || value->items.size() > units.size()) {
    value->at.Fail(fmt::format("{} has {} numbers, must have {}", name, value->items.size(),
                               least == units.size() ? std::to_string(least)
                                                     : fmt::format("{}..{}", least, units.size())));
  }
  std::vector<double> numbers;
  for (const PlayerValue& item : value->items) {
    if (item.kind != PlayerValue::Kind::kNumber) {
      item.at.Fail(fmt::format("{} must be a tuple of numbers, not of strings", name));
    }
    const char unit = units[numbers.size()];
    numbers.push_back(item.number * (unit == 'l'   ? file_.length_unit
                                     : unit == 'a' ? file_.angle_unit
                                                   : 1.0));
  }
  return numbers;
}

std::vector<std::string> PropertyReader::Texts(std::string_view name) {
  const PlayerValue* const value = Find(name);
  if (value == nullptr) return {};
  if (value->kind == PlayerValue::Kind::kText) return {value->text};
  if (value->kind != PlayerValue::Kind::kTuple) {
    value->at.Fail(
        fmt::format("{} must be a tuple of strings, as [\"laser:0\"], not a number", name));
  }
  std::vector<std::string> texts;
  for (const PlayerValue& item : value->items) {
    if (item.kind != PlayerValue::Kind::kText) {
      item.at.Fail(fmt::format("{} must be a tuple of strings, not of numbers", name));
    }
    texts.push_back(item.text);
  }
  return texts;
}

std::vector<const PlayerProperty*> PropertyReader::Unused() const {
  std::vector<const PlayerProperty*> unused;
  std::set<std::string> named;
  for (std::size_t i = 0; i < entity_.properties.size(); ++i) {
    const PlayerProperty& property = entity_.properties[i];
    if (!asked_[i] && named.insert(property.name).second) unused.push_back(&property);
  }
  return unused;
}

}  // namespace ccmorse::scene
