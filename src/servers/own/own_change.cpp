#include "servers/own/own_change.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "base/error.h"
#include "base/trig.h"
#include "sim/robots/robot.h"

namespace ccmorse::servers {
namespace {

constexpr double kFarthestOwn = 1e6;  // m; m/s
constexpr double kFarCell = 1e9;
constexpr double kMostCells = 4096.0;  // of the canvas, each way

// What can be done, how many numbers it takes, and within which limits they are.
struct Verb {
  const char* name;
  std::size_t numbers;
  std::array<double, 8> most;  // of each number's absolute value
};

constexpr std::array<Verb, 6> kVerbs = {{
    {"speed", 3, {kFarthestOwn, kFarthestOwn, kFarthestOwn}},
    {"place", 3, {kFarthestOwn, kFarthestOwn, kFarthestOwn}},
    {"pixel", 6, {kFarCell, kFarCell, 255.0, 255.0, 255.0, 1.0}},
    {"line", 8, {kFarCell, kFarCell, kFarCell, kFarCell, 255.0, 255.0, 255.0, 1.0}},
    {"clear", 0, {}},
    {"resize", 2, {kMostCells, kMostCells}},
}};

using Numbers = std::array<double, 8>;

Color ColorAt(const Numbers& numbers, std::size_t first) {
  const auto channel = [&](std::size_t index) {
    return static_cast<std::uint8_t>(std::fmax(0.0, std::round(numbers[first + index])));
  };
  return {channel(0), channel(1), channel(2)};
}

int Cell(double number) { return static_cast<int>(std::floor(number)); }

}  // namespace

OwnChange::Deed OwnChange::ParseDeed(const Json& deed) {
  if (!deed.IsArray() || deed.AsArray().empty() || !deed.AsArray().front().IsString()) {
    throw Error("what it does must be a list that begins with a word");
  }
  const Json::Array& words = deed.AsArray();
  const std::string& name = words.front().AsString();
  const Verb* verb = nullptr;
  for (const Verb& each : kVerbs) {
    if (name == each.name) verb = &each;
  }
  if (verb == nullptr) throw Error(fmt::format("'{}' is nothing that can be done", name));
  if (words.size() != verb->numbers + 1) {
    throw Error(fmt::format("{} takes {} numbers, not {}", name, verb->numbers, words.size() - 1));
  }
  Numbers numbers{};
  for (std::size_t i = 0; i < verb->numbers; ++i) {
    const Json& word = words[i + 1];
    if (!word.IsNumber() || !(std::fabs(word.AsDouble()) <= verb->most[i])) {
      throw Error(fmt::format("number {} of {} must be within +-{}, not {}", i + 1, name,
                              verb->most[i], word.Dump().substr(0, 40)));
    }
    numbers[i] = word.AsDouble();
  }
  if (name == "speed") {
    return [numbers](sim::Simulation&, sim::Component& component) {
      component.robot().Command({numbers[0], numbers[2], numbers[1]},
                                dynamic_cast<const sim::Actuator*>(&component));
    };
  }
  if (name == "place") {
    return [numbers](sim::Simulation& simulation, sim::Component& component) {
      component.robot().Place({numbers[0], numbers[1], NormalizeAngle(numbers[2])});
      simulation.world().RobotsMoved();
    };
  }
  if (name == "pixel") {
    return [numbers](sim::Simulation& simulation, sim::Component&) {
      simulation.canvas().SetPixel(Cell(numbers[0]), Cell(numbers[1]), ColorAt(numbers, 2),
                                   std::fmax(0.0, numbers[5]));
    };
  }
  if (name == "line") {
    return [numbers](sim::Simulation& simulation, sim::Component&) {
      simulation.canvas().DrawLine(Cell(numbers[0]), Cell(numbers[1]), Cell(numbers[2]),
                                   Cell(numbers[3]), ColorAt(numbers, 4),
                                   std::fmax(0.0, numbers[7]));
    };
  }
  if (name == "clear") {
    return [](sim::Simulation& simulation, sim::Component&) {
      simulation.canvas().Resize(simulation.canvas().width(), simulation.canvas().height());
    };
  }
  if (numbers[0] < 1.0 || numbers[1] < 1.0) throw Error("a canvas has at least one cell each way");
  return [numbers](sim::Simulation& simulation, sim::Component&) {
    simulation.canvas().Resize(Cell(numbers[0]), Cell(numbers[1]));
  };
}

OwnChange OwnChange::Parse(const Json& change) {
  if (!change.IsObject()) throw Error("what own code has done must be an object");
  OwnChange parsed;
  for (const auto& [key, value] : change.AsObject()) {
    if (key == "data" && value.IsObject()) {
      parsed.data_ = value;
    } else if (key == "do" && value.IsArray()) {
      for (const Json& deed : value.AsArray()) parsed.deeds_.push_back(ParseDeed(deed));
    } else if (key == "off" && value.IsBool()) {
      parsed.off_ = true;
    } else {
      throw Error(fmt::format("what own code has done has no '{}' like that", key));
    }
  }
  return parsed;
}

void OwnChange::Apply(sim::Simulation& simulation, sim::OwnComponent& component) const {
  for (const Deed& deed : deeds_) deed(simulation, component.component());
  if (!data_.IsNull()) component.SetData(data_, simulation.time());
  if (off_) component.component().set_active(false);
}

}  // namespace ccmorse::servers
