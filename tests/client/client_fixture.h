#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "libCCMorse/CCMorse.h"
#include "tests/support/fake_server.h"

namespace ccmorse::test {

inline constexpr char kHost[] = "127.0.0.1";

/// The MorseError that `act` throws; a failure of the test when it throws none.
template <class Act>
CCMorse::MorseError ErrorOf(const Act& act) {
  try {
    act();
  } catch (const CCMorse::MorseError& error) {
    return error;
  }
  ADD_FAILURE() << "no MorseError came";
  return CCMorse::MorseError();
}

/// Whether `text` contains `part`, with both in the failure's message.
inline ::testing::AssertionResult Has(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "\"" << part << "\" is not in \"" << text << "\"";
}

inline FakeServer::Options Plain() {
  FakeServer::Options options;
  options.ccmorse = false;
  options.properties = false;
  options.pen = false;
  return options;
}

inline FakeServer::Options WithPace(const std::string& pace) {
  FakeServer::Options options;
  options.pace = pace;
  return options;
}

inline double SecondsOf(const std::chrono::steady_clock::time_point& start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

using Lines = std::vector<std::string>;

}  // namespace ccmorse::test
