#include "tools/project_files.h"

#include <gtest/gtest.h>

#include "scene/scenario.h"
#include "tests/support/process.h"

namespace ccmorse::tools {
namespace {

TEST(ProjectFiles, NamesOfPackages) {
  EXPECT_EQ(ProblemOfPythonName("my_env2"), "");
  for (const char* name :
       {"", "my env", "my-env", "2d", "class", "morse", "json", "ärger", "a.b"}) {
    EXPECT_NE(ProblemOfPythonName(name), "") << name;
    const std::string better = AsPythonName(name);
    if (!better.empty()) {
      EXPECT_EQ(ProblemOfPythonName(better), "") << better;
    }
  }
  EXPECT_EQ(AsPythonName("my env"), "my_env");
  EXPECT_EQ(AsPythonName("2d"), "env_2d");
  EXPECT_EQ(AsPythonName("--"), "");
}

TEST(ProjectFiles, ClassNamesAreMorses) {
  EXPECT_EQ(ClassName("robotproperties"), "Robotproperties");
  EXPECT_EQ(ClassName("myPen"), "Mypen");
}

TEST(ProjectFiles, TheScenarioOfANewProjectIsSound) {
  for (const ProjectFile& file : NewProject("x", true)) {
    if (file.path != "scenario.json") continue;
    const testing::TemporaryFile scenario(".json", file.content);
    EXPECT_EQ(scene::LoadScenario(scenario.path()).robots.size(), 1U);
    return;
  }
  FAIL();
}

TEST(ProjectFiles, ADescriptionCannotBreakTheSource) {
  for (const ProjectFile& file :
       NewComponent(ComponentKind::kSensor, "probe", "env", "a \"\"\" b \\ c\nd @CLASS@")) {
    EXPECT_EQ(file.content.find("a \"\"\""), std::string::npos) << file.content;
    EXPECT_EQ(file.content.find('\\'), std::string::npos) << file.content;
    EXPECT_EQ(file.content.find("@NAME@"), std::string::npos) << file.content;
  }
}

}  // namespace
}  // namespace ccmorse::tools
