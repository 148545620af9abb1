#pragma once

#include <string>

#include "imr-h/imr_exceptions.h"

namespace imr {

/// Throws `Exception(message)` unless `condition` holds. `Exception` is imr::exception or one of
/// its kinds. These checks stay in release builds, unlike the standard assert().
template <class Exception>
void assert_exception(bool condition, const std::string& message) {
  if (!condition) throw Exception(message);
}

/// Throws argument_error with `message` unless `condition` holds. A pointer may be given for the
/// condition: null fails (thesis C.2 l.59-60).
inline void assert_argument(bool condition, const std::string& message) {
  assert_exception<argument_error>(condition, message);
}

/// Throws bad_usage with `message` unless `condition` holds.
inline void assert_usage(bool condition, const std::string& message) {
  assert_exception<bad_usage>(condition, message);
}

/// Throws io_error with `message` unless `condition` holds.
inline void assert_io(bool condition, const std::string& message) {
  assert_exception<io_error>(condition, message);
}

}  // namespace imr

/// As imr::assert_argument(), but builds the message only when the check fails.
#define ASSERT_ARGUMENT(condition, message)                   \
  do {                                                        \
    if (!(condition)) throw ::imr::argument_error((message)); \
  } while (false)

/// As imr::assert_io(), but builds the message only when the check fails.
#define ASSERT_IO(condition, message)                   \
  do {                                                  \
    if (!(condition)) throw ::imr::io_error((message)); \
  } while (false)
