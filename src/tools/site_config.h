#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ccmorse::tools {

/// MORSE's ~/.morse/config as text (specification: MORSE 1.4's command line): an INI file as
/// Python's configparser reads it, of whose section [sites] each line "name = path" is an
/// environment. Only lines of ours change; all else, comments and other sections too, stays as it
/// is, byte for byte. Not thread safe.
class SiteConfig {
 public:
  struct Site {
    std::string name;  ///< as the file spells it; MORSE and we look without regard to case
    std::string path;
  };

  /// Takes any text: what is no line of [sites] is kept and not understood. `section` is for files
  /// of the same form with another section.
  explicit SiteConfig(std::string text, std::string section = "sites");

  /// In the order of the file; of a name that is there twice, the last one, as configparser does.
  std::vector<Site> Sites() const;

  /// The one of this name, in any case.
  std::optional<Site> Find(std::string_view name) const;

  /// Adds a site at the end of the section, or changes the path of the one of this name, whose
  /// spelling becomes this one. `name` must be one that ProblemOfName() lets pass, `path` one line.
  void Set(const std::string& name, const std::string& path);

  /// Takes a site out, with the lines that continue it. False when there is none of this name.
  bool Remove(std::string_view name);

  const std::string& text() const { return text_; }

  /// What keeps a name from being a key of the file: "is empty", "has a '='", ...; "" for a good
  /// one.
  static std::string ProblemOfName(std::string_view name);

 private:
  struct Line {
    std::size_t begin = 0;  // in text_
    std::size_t end = 0;    // behind its line feed
    Site site;              // name "": none
  };
  std::vector<Line> Lines() const;
  std::string LineEnd() const;

  std::string text_;
  std::string section_;
  std::size_t section_end_ = std::string::npos;  // where a new site goes
  void FindSectionEnd();
};

}  // namespace ccmorse::tools
