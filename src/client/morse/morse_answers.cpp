#include <cmath>

#include "base/json.h"
#include "libCCMorse/MorseAnswers.h"
#include "libCCMorse/MorseError.h"

namespace CCMorse {
namespace {

using ccmorse::Json;

const bool kAnswersRegistered =
    RegisterMorseDevice({{"answers"}, {"Answers"}, [](const MorseDeviceInfo& info) {
                           return std::make_unique<MorseAnswers>(info);
                         }});

// The simulator has no use for NaN, and would only say so later.
void RequireFinite(double number, const char* function) {
  if (!std::isfinite(number)) throw MorseError("a number is not finite", function);
}

}  // namespace

MorseAnswers::MorseAnswers(const MorseDeviceInfo& info) : MorseActuator(info) {}

void MorseAnswers::SubmitJson(const std::string& name, const std::string& json) {
  Request("submit", MorseArgs(name).Add(MorseValue::Parse(json)));
}

void MorseAnswers::Submit(const std::string& name, const std::vector<double>& numbers) {
  MorseArgs list;
  for (const double number : numbers) {
    RequireFinite(number, "MorseAnswers::Submit()");
    list.Add(number);
  }
  Request("submit", MorseArgs(name).Add(list));
}

void MorseAnswers::SubmitPath(const std::vector<player_point_2d_t>& points,
                              const std::string& name) {
  MorseArgs list;
  for (const player_point_2d_t& point : points) {
    RequireFinite(point.px, "MorseAnswers::SubmitPath()");
    RequireFinite(point.py, "MorseAnswers::SubmitPath()");
    list.Add(MorseArgs(point.px, point.py));
  }
  Request("submit", MorseArgs(name).Add(list));
}

void MorseAnswers::SubmitPose(double x, double y, double yaw, const std::string& name) {
  Submit(name, std::vector<double>{x, y, yaw});
}

void MorseAnswers::SubmitGrid(const std::string& name, int width, int height,
                              const std::string& cells, double cell_size, double origin_x,
                              double origin_y) {
  const char* const function = "MorseAnswers::SubmitGrid()";
  if (width < 1 || height < 1 ||
      cells.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) ||
      cells.find_first_not_of("01?") != std::string::npos) {
    throw MorseError("a grid has width times height cells of '0', '1' and '?'", function);
  }
  for (const double number : {cell_size, origin_x, origin_y}) RequireFinite(number, function);
  const Json grid(Json::Object{{"width", width},
                               {"height", height},
                               {"cell_size", cell_size},
                               {"origin", Json::Array{origin_x, origin_y}},
                               {"cells", cells}});
  SubmitJson(name, grid.Dump());
}

std::vector<std::string> MorseAnswers::GetSubmitted() const {
  return Request("submitted").GetStrings("");
}

}  // namespace CCMorse
