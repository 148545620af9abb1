#include "sim/actuators/answers.h"

#include <utility>

#include "sim/robots/robot.h"

namespace ccmorse::sim {

Answers::Answers(Robot& robot, const std::string& name) : Actuator(robot, name, "Answers", 60.0) {
  AddService({"submit", {{"name"}, {"value"}}, [this](Arguments arguments) {
                Submit(arguments);
                return Json();
              }});
  AddQuery({"submitted", {}, [this](Arguments) {
              Json::Array names;
              for (const auto& entry : answers_) names.emplace_back(entry.first);
              return Json(std::move(names));
            }});
}

void Answers::Submit(Arguments arguments) {
  const std::string& name = StringArgument(arguments, 0, "name");
  if (name.empty() || name.size() > kLongestName) {
    throw WrongArgument("name must have 1 to " + std::to_string(kLongestName) + " bytes");
  }
  // Kept as text, which takes a small part of the memory that a tree of values would.
  std::string text = arguments[1].Dump();
  if (text.size() > kLongestValue) {
    throw WrongArgument("value must have " + std::to_string(kLongestValue) +
                        " bytes at most, not " + std::to_string(text.size()));
  }
  const auto found = answers_.find(name);
  if (found == answers_.end() && answers_.size() >= kMostAnswers) {
    throw ServiceFailed("There are " + std::to_string(kMostAnswers) +
                        " answers already; only those can be replaced");
  }
  ++revision_;
  StateHash& hash = robot().hash();
  hash.Add(name);
  hash.Add(text);
  answers_[name] = {std::move(text), revision_};
}

void Answers::Receive(const Json&) {
  throw WrongArgument("answers take the service submit, not stream messages");
}

void Answers::Reset() {
  Actuator::Reset();
  answers_.clear();
}

}  // namespace ccmorse::sim
