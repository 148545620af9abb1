#pragma once

#include <cstdlib>  // programs of the course call exit() and include nothing for it (C.2 l.107)
#include <stdexcept>
#include <string>

namespace imr {

/// Root of every exception that the support library throws (thesis C.2 l.105).
///
/// It carries one message, which what() returns. Copying and catching it is safe in every thread.
class exception : public std::runtime_error {
 public:
  /// @param what The message, one line in plain words.
  explicit exception(const std::string& what) : std::runtime_error(what) {}
};

/// One distinct exception type a kind of error; `Kind` only tells the types apart. Programs use the
/// names below, and may catch all of them as imr::exception.
template <int Kind>
class exception_base : public exception {
 public:
  /// @param what The message, one line in plain words.
  explicit exception_base(const std::string& what) : exception(what) {}
};

/// A function was given an argument that it cannot work with.
typedef exception_base<0> argument_error;
/// A file or a device cannot be read or written.
typedef exception_base<1> io_error;
/// A packet of a protocol is malformed.
typedef exception_base<2> packet_error;
/// A datagram is malformed or lost.
typedef exception_base<3> datagram_error;
/// An object cannot be written to, or read back from, its serial form.
typedef exception_base<4> serialization_error;
/// A message could not be delivered.
typedef exception_base<5> delivery_error;
/// The program contradicts itself.
typedef exception_base<6> bad_code;
/// The library or the program is used wrongly: an unknown option, a thread started twice.
typedef exception_base<7> bad_usage;

}  // namespace imr

// assert_argument() and its relatives: programs include this header alone to use them (C.2 l.59).
#include "imr-h/imr_assert.h"
