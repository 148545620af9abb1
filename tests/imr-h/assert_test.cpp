// Checks and exceptions. Only the two headers that robot.cc of the thesis includes come before the
// class, and the check is called with a pointer and unqualified, as there (C.2 l.4-5, 59).
#include "imr-h/imr_exceptions.h"
#include "imr-h/logging.h"
// The two above stand first on purpose: they must suffice for the class below.

#include <gtest/gtest.h>

#include <type_traits>

namespace imr {
namespace robot {

class CChecked {
 public:
  explicit CChecked(int* device);
};

}  // namespace robot
}  // namespace imr

using namespace imr::robot;

CChecked::CChecked(int* device) {
  assert_argument(device, "Can not create laser proxy");
  DEBUG("CChecked: Done.");
}

TEST(X16, AssertArgumentTakesAPointerUnqualifiedFromInsideImrRobot) {
  int device = 0;
  EXPECT_NO_THROW(CChecked{&device});
  try {
    CChecked checked(nullptr);
    FAIL() << "a null pointer must be refused";
  } catch (const imr::exception& e) {
    EXPECT_STREQ(e.what(), "Can not create laser proxy");
  }
  EXPECT_THROW(CChecked(nullptr), imr::argument_error);
}

TEST(X16, EachCheckThrowsItsOwnKind) {
  EXPECT_NO_THROW(imr::assert_usage(true, "fine"));
  EXPECT_THROW(imr::assert_usage(false, "wrong"), imr::bad_usage);
  EXPECT_THROW(imr::assert_io(false, "wrong"), imr::io_error);
  EXPECT_THROW(imr::assert_exception<imr::packet_error>(false, "wrong"), imr::packet_error);
  EXPECT_THROW(ASSERT_ARGUMENT(1 > 2, "wrong"), imr::argument_error);
  EXPECT_THROW(ASSERT_IO(false, "wrong"), imr::io_error);
  EXPECT_NO_THROW(ASSERT_IO(true, "fine"));
}

TEST(X21, ExceptionIsARuntimeErrorWithItsMessage) {
  static_assert(std::is_base_of_v<std::runtime_error, imr::exception>);
  static_assert(std::is_base_of_v<imr::exception, imr::bad_usage>);
  static_assert(!std::is_same_v<imr::bad_usage, imr::argument_error>);
  static_assert(!std::is_convertible_v<std::string, imr::exception>, "construction is explicit");
  try {
    throw imr::delivery_error("lost");
  } catch (imr::exception& e) {
    EXPECT_STREQ(e.what(), "lost");
  }
}
