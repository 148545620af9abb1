#include "tools/site_config.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace ccmorse::tools {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f\v";

std::string_view Trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

char Lower(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool SameName(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return Lower(x) == Lower(y); });
}

// configparser writes a percent sign of a value twice.
std::string Unescaped(std::string_view value) {
  std::string plain;
  for (std::size_t i = 0; i < value.size(); ++i) {
    plain += value[i];
    if (value[i] == '%' && i + 1 < value.size() && value[i + 1] == '%') ++i;
  }
  return plain;
}

std::string Escaped(std::string_view value) {
  std::string text;
  for (const char letter : value) text.append(letter == '%' ? 2 : 1, letter);
  return text;
}

}  // namespace

SiteConfig::SiteConfig(std::string text, std::string section)
    : text_(std::move(text)), section_(std::move(section)) {
  FindSectionEnd();
}

std::vector<SiteConfig::Line> SiteConfig::Lines() const {
  std::vector<Line> lines;
  bool inside = false;
  bool in_value = false;         // the lines above belong to a value that may go on
  std::size_t value_indent = 0;  // of the line that the value began on
  for (std::size_t begin = 0; begin < text_.size();) {
    const std::size_t feed = text_.find('\n', begin);
    Line line;
    line.begin = begin;
    line.end = feed == std::string::npos ? text_.size() : feed + 1;
    begin = line.end;
    const std::string_view whole =
        std::string_view(text_).substr(line.begin, line.end - line.begin);
    const std::string_view content = Trimmed(whole);
    const std::size_t indent = std::min(whole.find_first_not_of(kBlanks), whole.size());
    if (content.empty() || content.front() == '#' || content.front() == ';') {
      if (inside) lines.push_back(line);
      continue;
    }
    if (in_value && indent > value_indent) {
      // Goes with the line above: whoever takes that away, takes this, too.
      if (inside && !lines.empty()) lines.back().end = line.end;
      continue;
    }
    in_value = false;
    if (content.front() == '[' && content.find(']') != std::string_view::npos) {
      inside = content.substr(1, content.find(']') - 1) == section_;
      if (inside) lines.push_back(line);
      continue;
    }
    const std::size_t delimiter = content.find_first_of("=:");
    if (delimiter != std::string_view::npos && delimiter > 0) {
      in_value = true;
      value_indent = indent;
      line.site = {std::string(Trimmed(content.substr(0, delimiter))),
                   Unescaped(Trimmed(content.substr(delimiter + 1)))};
    }
    if (inside) lines.push_back(line);
  }
  return lines;
}

void SiteConfig::FindSectionEnd() {
  section_end_ = std::string::npos;
  for (const Line& line : Lines()) {
    const std::string_view whole =
        std::string_view(text_).substr(line.begin, line.end - line.begin);
    // Blank lines at the end of a section stand before the next one's head.
    if (!Trimmed(whole).empty()) section_end_ = line.end;
  }
}

std::vector<SiteConfig::Site> SiteConfig::Sites() const {
  std::vector<Site> sites;
  for (const Line& line : Lines()) {
    if (line.site.name.empty()) continue;
    const auto same = std::find_if(sites.begin(), sites.end(), [&line](const Site& site) {
      return SameName(site.name, line.site.name);
    });
    if (same == sites.end()) {
      sites.push_back(line.site);
    } else {
      *same = line.site;
    }
  }
  return sites;
}

std::optional<SiteConfig::Site> SiteConfig::Find(std::string_view name) const {
  for (const Site& site : Sites()) {
    if (SameName(site.name, name)) return site;
  }
  return std::nullopt;
}

std::string SiteConfig::LineEnd() const {
  const std::size_t feed = text_.find('\n');
  return feed != std::string::npos && feed > 0 && text_[feed - 1] == '\r' ? "\r\n" : "\n";
}

void SiteConfig::Set(const std::string& name, const std::string& path) {
  const std::string entry = name + " = " + Escaped(path) + LineEnd();
  const std::vector<Line> lines = Lines();
  const auto same = std::find_if(lines.rbegin(), lines.rend(), [&name](const Line& line) {
    return !line.site.name.empty() && SameName(line.site.name, name);
  });
  if (same != lines.rend()) {
    text_.replace(same->begin, same->end - same->begin, entry);
  } else {
    std::size_t at = section_end_;
    std::string added = entry;
    if (at == std::string::npos) {
      at = text_.size();
      added.insert(0, fmt::format("{}[{}]{}", text_.empty() ? "" : LineEnd(), section_, LineEnd()));
    }
    if (at > 0 && text_[at - 1] != '\n') added.insert(0, LineEnd());
    text_.insert(at, added);
  }
  FindSectionEnd();
}

bool SiteConfig::Remove(std::string_view name) {
  std::vector<Line> lines = Lines();
  bool found = false;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    if (line->site.name.empty() || !SameName(line->site.name, name)) continue;
    text_.erase(line->begin, line->end - line->begin);
    found = true;
  }
  FindSectionEnd();
  return found;
}

std::string SiteConfig::ProblemOfName(std::string_view name) {
  if (Trimmed(name).empty()) return "is empty";
  if (Trimmed(name).size() != name.size()) return "begins or ends with a blank";
  for (const char letter : name) {
    if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f) {
      return "has a line break, tab or other control character";
    }
    if (letter == '=' || letter == ':' || letter == '/') return fmt::format("has a '{}'", letter);
  }
  constexpr std::string_view kNotFirst = "#;[-.";
  if (kNotFirst.find(name.front()) != std::string_view::npos) {
    return fmt::format("begins with '{}'", name.front());
  }
  return "";
}

}  // namespace ccmorse::tools
