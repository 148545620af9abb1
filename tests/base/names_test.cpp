#include <gtest/gtest.h>

#include "base/nearest_name.h"

namespace ccmorse {
namespace {

const std::vector<std::string> kKnown = {"robots", "canvas", "camera", "time", "seed", "pose"};

TEST(NearestName, FindsWhatWasMeant) {
  EXPECT_EQ(NearestName("robtos", kKnown), "robots");
  EXPECT_EQ(NearestName("Canvs", kKnown), "canvas");
  EXPECT_EQ(NearestName("postion", kKnown), "");
  EXPECT_EQ(NearestName("sed", kKnown), "seed");
}

TEST(NearestName, SaysNothingWhenNothingIsNear) {
  EXPECT_EQ(NearestName("zzzzzz", kKnown), "");
  EXPECT_EQ(DidYouMean("zzzzzz", kKnown), "");
  EXPECT_EQ(DidYouMean("robot", kKnown), "; did you mean 'robots'?");
}

}  // namespace
}  // namespace ccmorse
