#include "sim/actuators/answers.h"

#include <gtest/gtest.h>

#include <string>

#include "scene/scenario.h"
#include "sim/simulation.h"

namespace ccmorse::sim {
namespace {

class AnswersTest : public ::testing::Test {
 protected:
  Answers& answers() { return dynamic_cast<Answers&>(*simulation_.FindComponent("s1r.answers")); }
  Json Ask(const std::string& name, const Json::Array& arguments) {
    for (const Service& service : answers().services()) {
      if (service.name == name) return service.run(arguments);
    }
    throw std::runtime_error("no service " + name);
  }
  Simulation simulation_{scene::ParseScenario("{}", "test.json")};
};

TEST_F(AnswersTest, KeepsTheLastValueOfAName) {
  EXPECT_EQ(Ask("submitted", {}), Json(Json::Array{}));
  Ask("submit", {"path", Json::Array{1.5, 2}});
  Ask("submit", {"map", "old"});
  Ask("submit", {"map", "new"});
  EXPECT_EQ(Ask("submitted", {}), Json(Json::Array{"map", "path"}));
  EXPECT_EQ(answers().answers().at("path").text, "[1.5, 2]");
  EXPECT_EQ(answers().answers().at("map").text, "\"new\"");
  EXPECT_EQ(answers().answers().at("map").revision, 3U);
  EXPECT_EQ(answers().revision(), 3U);
}

TEST_F(AnswersTest, IsPartOfTheHashOnceSomethingIsSubmitted) {
  Simulation other(scene::ParseScenario("{}", "test.json"));
  EXPECT_EQ(simulation_.Hash(), other.Hash());
  Ask("submit", {"x", 1});
  const std::uint64_t one = simulation_.Hash();
  EXPECT_NE(one, other.Hash());
  Ask("submit", {"x", 1});  // a second submission is another input
  EXPECT_NE(simulation_.Hash(), one);
}

TEST_F(AnswersTest, TakesNoMoreThanItSays) {
  const std::string longest(Answers::kLongestValue - 2, 'a');  // two quotes more as JSON
  Ask("submit", {"long", longest});
  const std::uint64_t hash = simulation_.Hash();
  EXPECT_THROW(Ask("submit", {"longer", longest + "a"}), WrongArgument);
  EXPECT_THROW(Ask("submit", {"", 1}), WrongArgument);
  EXPECT_THROW(Ask("submit", {std::string(Answers::kLongestName + 1, 'n'), 1}), WrongArgument);
  EXPECT_THROW(Ask("submit", {5, 1}), WrongArgument);
  for (std::size_t i = 1; i < Answers::kMostAnswers; ++i) {
    Ask("submit", {std::to_string(i), 0});
  }
  EXPECT_NE(simulation_.Hash(), hash);
  const std::uint64_t full = simulation_.Hash();
  EXPECT_THROW(Ask("submit", {"one more", 0}), ServiceFailed);
  EXPECT_EQ(answers().answers().size(), Answers::kMostAnswers);
  EXPECT_EQ(simulation_.Hash(), full);  // what is refused is as if it had never come
  Ask("submit", {"long", 0});
  EXPECT_EQ(answers().answers().at("long").text, "0");
}

TEST_F(AnswersTest, ResetForgetsThem) {
  Ask("submit", {"x", 1});
  simulation_.ResetObjects();
  EXPECT_TRUE(answers().answers().empty());
}

}  // namespace
}  // namespace ccmorse::sim
