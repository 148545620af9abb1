#include "scene/magnetic_field.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "base/error.h"

namespace ccmorse::scene {
namespace {

constexpr double kStrongest = 1e6;  // nT: the Earth's terms are below 3e4

bool IsTerm(const MagneticTerm& term) {
  bool good = term.degree >= 1 && term.degree <= kMostMagneticDegree && term.order >= 0 &&
              term.order <= term.degree;
  for (const double value : {term.g, term.h, term.g_rate, term.h_rate}) {
    good = good && std::fabs(value) <= kStrongest;
  }
  return good;
}

}  // namespace

MagneticFieldDef ParseMagneticField(const std::string& text, const std::string& file) {
  std::istringstream lines(text);
  std::string line;
  int number = 0;
  const auto fail = [&](const char* what) {
    return Error(fmt::format("{}:{}: {}", file, number, what));
  };
  MagneticFieldDef field;
  field.terms.clear();
  while (std::getline(lines, line)) {
    ++number;
    std::istringstream words(line);
    if (number == 1) {
      if (!(words >> field.epoch) || !(field.epoch > 0.0 && field.epoch < 1e4)) {
        throw fail("begins with no year: this is no file of a magnetic model");
      }
      continue;
    }
    if (line.rfind("9999", 0) == 0) break;
    MagneticTerm term;
    if (!(words >> term.degree >> term.order >> term.g >> term.h >> term.g_rate >> term.h_rate) ||
        !IsTerm(term)) {
      throw fail("is no line of n, m, g, h and their changes a year");
    }
    field.terms.push_back(term);
  }
  if (field.terms.empty()) throw fail("ends without any term");
  field.date = field.epoch;
  return field;
}

MagneticFieldDef LoadMagneticField(const std::string& file) {
  return ParseMagneticField(ReadFile(file), file);
}

}  // namespace ccmorse::scene
