#include "servers/net/warm_path.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>

namespace ccmorse::servers {
namespace {

std::ptrdiff_t OpenFiles() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
}

TEST(WarmPath, ManyPacketsLeaveNothingBehind) {
  const std::ptrdiff_t before = OpenFiles();
  {
    WarmPath path;
    EXPECT_TRUE(path.Works());
    EXPECT_EQ(OpenFiles(), before + 2);
    // More than the sockets' buffers hold: each is taken again.
    for (int i = 0; i < 5000; ++i) ASSERT_TRUE(path.Warm()) << i;
  }
  EXPECT_EQ(OpenFiles(), before);
}

TEST(WarmPath, WithoutFileHandlesItDoesNothing) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit none = before;
  none.rlim_cur = 3;
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  {
    WarmPath path;
    EXPECT_FALSE(path.Works());
    EXPECT_FALSE(path.Warm());
  }
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
}

}  // namespace
}  // namespace ccmorse::servers
