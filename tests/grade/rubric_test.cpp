#include "grade/rubric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace ccmorse::grade {
namespace {

const std::string kFile = std::string(CCMORSE_SOURCE_DIR) + "/tests/grade/task/rubric.json";

std::string Changed(const std::string& what, const std::string& with) {
  std::string text = ReadFile(kFile);
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(Rubric, IsReadWhole) {
  const Rubric rubric = LoadRubric(kFile);
  EXPECT_EQ(rubric.task, "task");
  EXPECT_EQ(rubric.program, "robot");
  EXPECT_EQ(rubric.arguments, (std::vector<std::string>{"{port}"}));
  EXPECT_EQ(rubric.seconds, 4.0);
  EXPECT_EQ(rubric.limits.processes, 16);
  EXPECT_EQ(rubric.limits.memory_mb, 200.0);
  ASSERT_EQ(rubric.worlds.size(), 1U);
  EXPECT_FALSE(rubric.worlds[0].random_start);
  ASSERT_EQ(rubric.criteria.size(), 2U);
  EXPECT_EQ(rubric.criteria[0].hint, "drive");
  EXPECT_EQ(rubric.pass, 60.0);
}

TEST(Rubric, ConditionsMayBeSeveralAndGoalsOfSeveralRobots) {
  const Rubric with_goals = ParseRubric(
      Changed("\"pass\": 60", R"("reference": {"goals": {"a": [[1, 2]], "b": [[3, 4], [5, 6]]}})"),
      kFile);
  ASSERT_EQ(with_goals.reference.goals.size(), 2U);
  EXPECT_EQ(with_goals.reference.goals.at("b")[1].x, 5.0);
  const Rubric of_first =
      ParseRubric(Changed("\"pass\": 60", R"("reference": {"goals": [[1, 2]]})"), kFile);
  EXPECT_EQ(of_first.reference.goals.at("").size(), 1U);
  const Rubric conditions = ParseRubric(
      Changed("\"none\": 1}", R"("none": 1, "only_if": [{"measure": "distance_m", "at_least": 2},
                                                        {"measure": "time_s", "at_most": 9}]})"),
      kFile);
  ASSERT_EQ(conditions.criteria[1].only_if.size(), 2U);
  EXPECT_EQ(conditions.criteria[1].only_if[0].least, 2.0);
  EXPECT_EQ(conditions.criteria[1].only_if[1].most, 9.0);
  EXPECT_TRUE(std::isinf(conditions.criteria[1].only_if[1].least));
}

TEST(Rubric, EveryMistakeIsNamedWithItsLine) {
  const std::vector<std::pair<std::pair<std::string, std::string>, std::string>> cases = {
      {{"\"seconds\"", "\"secnds\""}, "is 'secnds' meant"},
      {{"\"contacts\", \"weight\"", "\"contact\", \"weight\""}, "did you mean 'contacts'"},
      {{"\"weight\": 50, \"full\": 0,", "\"weight\": 40, \"full\": 0,"}, "must be 100"},
      {{"\"full\": 0, \"none\": 1", "\"full\": 1, \"none\": 1"}, "the same as 'none'"},
      {{"scenario.json", "nowhere.json"}, "is no file"},
      {{"\"distance_m\"", "\"wall_error_m\""}, "reference.wall_distance_m"},
      {{"\"robot\"", "\"../robot\""}, "name of a file"},
      {{"\"no contact\"", "\"way\""}, "name of another criterion"},
      {{"\"pass\": 60", "\"pass\": 600"}, "pass"},
      {{"\"none\": 1}", "\"none\": 1, \"only_if\": {\"measure\": \"time_s\"}}"},
       "only_if needs 'at_least' or 'at_most'"},
      {{"\"none\": 1}", "\"none\": 1, \"only_if\": [{\"measure\": \"times_s\", \"at_most\": 1}]}"},
       "did you mean 'time_s'"},
      {{"\"pass\": 60", "\"reference\": {\"goals\": {}}"}, "names no robot"},
      {{"\"pass\": 60", "\"reference\": {\"goals\": {\"s1r\": [[1]]}}"}, "must be [x, y]"}};
  for (const auto& [change, expected] : cases) {
    try {
      ParseRubric(Changed(change.first, change.second), kFile);
      ADD_FAILURE() << change.second << " was taken";
    } catch (const Error& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find(expected), std::string::npos) << text;
      EXPECT_NE(text.find("rubric.json:"), std::string::npos) << text;
    }
  }
}

TEST(Rubric, ThoseOfTheCoursesAreGood) {
  for (const char* folder :
       {"par/intro", "par/planning", "par/exploration", "syrotek/pid", "syrotek/wall_following",
        "syrotek/dead_reckoning", "syrotek/trajectory", "syrotek/two_robots"}) {
    const Rubric rubric =
        LoadRubric(std::string(CCMORSE_SOURCE_DIR) + "/courses/" + folder + "/rubric.json");
    EXPECT_TRUE(std::string(folder).ends_with("/" + rubric.task));
    for (const Criterion& criterion : rubric.criteria) EXPECT_FALSE(criterion.hint.empty());
  }
}

}  // namespace
}  // namespace ccmorse::grade
