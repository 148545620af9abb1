#pragma once

// Player's macros to print while a program is looked into (specs: player.md A.1): LOG, PRINT and
// EVAL print to standard error where DEBUG_LEVEL is at least LOW.

#include <iostream>

// NOLINTBEGIN(cppcoreguidelines-macro-usage): programs use these names as macros
#define NONE 0
#define LOW 1
#define MEDIUM 2
#define HIGH 3

#ifndef DEBUG_LEVEL
#define DEBUG_LEVEL NONE
#endif

#if DEBUG_LEVEL > NONE
#define LOG(text) std::cerr << __FILE__ << ":" << __LINE__ << ": " << text << std::endl
#define PRINT(text) std::cerr << text << std::endl
#define EVAL(value) std::cerr << #value << " = " << (value) << std::endl
#else
#define LOG(text) \
  do {            \
  } while (false)
#define PRINT(text) \
  do {              \
  } while (false)
#define EVAL(value) \
  do {              \
  } while (false)
#endif
// NOLINTEND(cppcoreguidelines-macro-usage)
