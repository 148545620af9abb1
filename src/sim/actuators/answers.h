#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// What a robot's program hands in to be judged: values of JSON by name, a path or a map, say. They
/// change nothing in the world, but they are inputs like any other: in the run's hash and record.
///
/// Services: submit(name, value) keeps the value under the name, in the place of an earlier one;
/// submitted() lists the names. Memory is bounded: what is beyond kMost... is refused, and what was
/// there before stays.
class Answers : public Actuator {
 public:
  static constexpr std::size_t kMostAnswers = 16;
  static constexpr std::size_t kLongestName = 64;            ///< bytes
  static constexpr std::size_t kLongestValue = 1024 * 1024;  ///< bytes of an answer as JSON

  struct Answer {
    std::string text;            ///< the value as JSON, as Json::Dump() writes it
    std::uint64_t revision = 0;  ///< which submission it was, from 1
  };

  Answers(Robot& robot, const std::string& name);

  /// By name.
  const std::map<std::string, Answer, std::less<>>& answers() const { return answers_; }
  /// How many submissions there were; who looks after each tick sees so in which one came.
  std::uint64_t revision() const { return revision_; }

  void Act(const Instant&) override {}
  void Receive(const Json& message) override;
  void Reset() override;
  /// Each submission counts when it comes, in the robot's own hash: who submits nothing adds
  /// nothing.
  void AddToHash(StateHash&) const override {}

 private:
  void AppendFields(std::string&) const override {}
  void Submit(Arguments arguments);

  std::map<std::string, Answer, std::less<>> answers_;
  std::uint64_t revision_ = 0;
};

}  // namespace ccmorse::sim
