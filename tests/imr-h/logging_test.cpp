#include "imr-h/logging.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "imr-h/imr_exceptions.h"

namespace {

// Collects standard output, and puts the level back afterwards.
class ImrLogging : public testing::Test {
 protected:
  ImrLogging() : old_(std::cout.rdbuf(text_.rdbuf())), level_(imr::getLogLevel()) {
    imr::setLogLevel(imr::LogLevel::kDebug);
  }
  ~ImrLogging() override {
    std::cout.rdbuf(old_);
    imr::setLogLevel(level_);
  }

  // What was written since the last call.
  std::string Text() {
    const std::string text = text_.str();
    text_.str("");
    return text;
  }

 private:
  std::ostringstream text_;
  std::streambuf* old_;
  imr::LogLevel level_;
};

// Names the ids in the names of the tests.
using X22 = ImrLogging;

}  // namespace

namespace elsewhere {
void LogFromAnotherNamespace() {
  INFO("from "
       << "elsewhere");
}
}  // namespace elsewhere

TEST_F(X22, MacrosTakeAStreamExpression) {
  DEBUG("x " << 3);
  INFO("y " << 1.5 << " m");
  WARN("careful");
  ERROR("Morse error: " << std::string("lost") << " function: " << 'f');
  elsewhere::LogFromAnotherNamespace();
  EXPECT_EQ(Text(),
            "DEBUG: x 3\nINFO: y 1.5 m\nWARN: careful\nERROR: Morse error: lost function: f\n"
            "INFO: from elsewhere\n");
}

TEST_F(X22, MacrosAreOneStatement) {
  const auto log = [](bool wrong) {
    if (wrong)
      ERROR("wrong");
    else
      INFO("right");
  };
  log(true);
  log(false);
  EXPECT_EQ(Text(), "ERROR: wrong\nINFO: right\n");
}

TEST_F(ImrLogging, LevelLimitsWhatIsWrittenAndEvaluated) {
  int evaluated = 0;
  imr::setLogLevel(imr::LogLevel::kInfo);
  DEBUG("hidden " << ++evaluated);
  INFO("shown " << ++evaluated);
  imr::setLogLevel(imr::LogLevel::kError);
  WARN("hidden");
  ERROR("shown");
  imr::setLogLevel(imr::LogLevel::kOff);
  ERROR("hidden");
  EXPECT_EQ(Text(), "INFO: shown 1\nERROR: shown\n");
  EXPECT_EQ(evaluated, 1);
}

TEST_F(ImrLogging, LevelsAreReadFromText) {
  EXPECT_EQ(imr::logLevelFromText("debug"), imr::LogLevel::kDebug);
  EXPECT_EQ(imr::logLevelFromText("Info"), imr::LogLevel::kInfo);
  EXPECT_EQ(imr::logLevelFromText("WARN"), imr::LogLevel::kWarn);
  EXPECT_EQ(imr::logLevelFromText("error"), imr::LogLevel::kError);
  EXPECT_EQ(imr::logLevelFromText("off"), imr::LogLevel::kOff);
  EXPECT_THROW(imr::logLevelFromText("loud"), imr::bad_usage);
}

TEST_F(ImrLogging, LoggersHaveNamesAndAreShared) {
  imr::CLoggerPtr planner = imr::getLogger("planner");
  EXPECT_EQ(planner, imr::getLogger("planner"));
  EXPECT_NE(planner, imr::getLogger("control"));
  INFO_M(planner, "path of " << 12 << " nodes");
  DEBUG_M(planner, "d");
  WARN_M(planner, "w");
  ERROR_M(planner, "e");
  EXPECT_EQ(Text(),
            "INFO: planner: path of 12 nodes\nDEBUG: planner: d\nWARN: planner: w\n"
            "ERROR: planner: e\n");
}

TEST_F(ImrLogging, InitAndShutdownKeepLoggingPossible) {
  using imr::logger;
  ASSERT_NE(logger, nullptr);
  imr::initLogger("course");
  EXPECT_EQ(logger, imr::getLogger("course"));
  INFO_M(logger, "hello");
  INFO("plain");
  imr::shutdownLogger();
  imr::warn("late");
  imr::error("later");
  EXPECT_EQ(Text(), "INFO: course: hello\nINFO: plain\nWARN: late\nERROR: later\n");
  imr::initLogger("");
}

TEST_F(ImrLogging, Log4cxxFileSetsTheLevel) {
  const std::string file = testing::TempDir() + "imr_logging_test.properties";
  std::ofstream(file) << "# log\n log4j.rootLogger = WARN, A1\nlog4j.appender.A1=Console\n";
  imr::initLogger("course", file);
  EXPECT_EQ(imr::getLogLevel(), imr::LogLevel::kWarn);
  std::ofstream(file) << "log4j.rootCategory=NOISY\n";
  EXPECT_THROW(imr::initLogger("course", file), imr::bad_usage);
  std::remove(file.c_str());
  EXPECT_THROW(imr::initLogger("course", file), imr::io_error);
  imr::initLogger("");
}

TEST_F(ImrLogging, LinesOfSeveralThreadsStayWhole) {
  constexpr int kThreads = 4;
  constexpr int kLines = 500;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([t] {
      for (int i = 0; i < kLines; ++i) INFO("thread " << t << " line " << i << " end");
    });
  }
  for (std::thread& thread : threads) thread.join();

  std::map<int, int> next;  // the lines of one thread keep their order
  std::istringstream lines(Text());
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    int thread = -1;
    int number = -1;
    char end = '\0';
    ASSERT_EQ(std::sscanf(line.c_str(), "INFO: thread %d line %d en%c", &thread, &number, &end), 3)
        << line;
    EXPECT_EQ(number, next[thread]++);
  }
  EXPECT_EQ(count, kThreads * kLines);
}

TEST_F(ImrLogging, PointerChecksEndTheProgram) {
  const int* nothing = nullptr;
  int something = 0;
  PTR_CHECK(&something, imr::logger);
  EXPECT_EXIT(PTR_CHECK(nothing, imr::logger), testing::ExitedWithCode(254), "");
  EXPECT_EXIT(MEM_CHECK(nothing, imr::logger), testing::ExitedWithCode(254), "");
}

// The environment is read once, at the first message, so a process of its own looks at it.
TEST(ImrLoggingDeathTest, EnvironmentSetsTheLevel) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  setenv("IMR_LOG", "warn", 1);
  EXPECT_EXIT(std::exit(imr::getLogLevel() == imr::LogLevel::kWarn ? 0 : 1),
              testing::ExitedWithCode(0), "");
  setenv("IMR_LOG", "shout", 1);
  EXPECT_EXIT(std::exit(imr::getLogLevel() == imr::LogLevel::kDebug ? 0 : 1),
              testing::ExitedWithCode(0), "");
  unsetenv("IMR_LOG");
}
