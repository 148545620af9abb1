// What a batch says about how far it is.

#include "tools/batch_progress.h"

#include <gtest/gtest.h>

namespace ccmorse::tools {
namespace {

using std::chrono::seconds;

TEST(BatchProgress, TheEstimateIsOfThisStartsJobsOnly) {
  BatchProgress progress(100, 40, true);
  const auto start = BatchProgress::Clock::now();
  EXPECT_EQ(progress.Line(start, 0), "40 of 100");
  for (int i = 0; i < 10; ++i) progress.JobOver("");
  progress.JobOver("failed: x");
  progress.JobOver("failed: y");
  // 12 jobs in a minute leave 48 for 240 s.
  EXPECT_EQ(progress.Line(start + seconds(60), 0), "52 of 100, 2 failed, about 4 min 0 s left");
  EXPECT_EQ(progress.failed(), 2);
}

TEST(BatchProgress, TheBarFillsTheWidthAndStaysWithinIt) {
  BatchProgress progress(4, 0, true);
  const auto start = BatchProgress::Clock::now();
  EXPECT_EQ(progress.Line(start, 24), "[>              ] 0 of 4");
  progress.JobOver("");
  progress.JobOver("");
  for (int width = 0; width < 200; ++width) {
    const std::string line = progress.Line(start + seconds(4), width);
    EXPECT_NE(line.find("2 of 4, about 4 s left"), std::string::npos) << line;
    EXPECT_TRUE(line[0] != '[' || static_cast<int>(line.size()) <= width) << line;
  }
  EXPECT_EQ(progress.Line(start + seconds(4), 45).substr(0, 22), "[==========>         ]");
  progress.JobOver("");
  progress.JobOver("");
  EXPECT_EQ(progress.Line(start + seconds(5), 24), "[===============] 4 of 4");
}

TEST(BatchProgress, DurationsAreForPeople) {
  EXPECT_EQ(DurationText(0.2), "0 s");
  EXPECT_EQ(DurationText(59.4), "59 s");
  EXPECT_EQ(DurationText(80), "1 min 20 s");
  EXPECT_EQ(DurationText(11100), "3 h 5 min");
  EXPECT_EQ(DurationText(1e300), DurationText(1e9));
}

}  // namespace
}  // namespace ccmorse::tools
