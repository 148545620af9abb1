#pragma once

// Player's macros for messages to people (specs: player.md A.1): errors and warnings go to standard
// error, messages to standard output. The format is printf's. `level` of a message: only those up
// to 1 are printed.

#include <cstdio>

// NOLINTBEGIN(cppcoreguidelines-macro-usage): programs use these names as macros
#define PLAYER_ERROR(msg) std::fprintf(stderr, "error   : " msg "\n")
#define PLAYER_ERROR1(msg, a) std::fprintf(stderr, "error   : " msg "\n", a)
#define PLAYER_ERROR2(msg, a, b) std::fprintf(stderr, "error   : " msg "\n", a, b)
#define PLAYER_ERROR3(msg, a, b, c) std::fprintf(stderr, "error   : " msg "\n", a, b, c)
#define PLAYER_WARN(msg) std::fprintf(stderr, "warning : " msg "\n")
#define PLAYER_WARN1(msg, a) std::fprintf(stderr, "warning : " msg "\n", a)
#define PLAYER_WARN2(msg, a, b) std::fprintf(stderr, "warning : " msg "\n", a, b)
#define PLAYER_WARN3(msg, a, b, c) std::fprintf(stderr, "warning : " msg "\n", a, b, c)
#define PLAYER_MSG0(level, msg) ((level) <= 1 ? std::printf(msg "\n") : 0)
#define PLAYER_MSG1(level, msg, a) ((level) <= 1 ? std::printf(msg "\n", a) : 0)
#define PLAYER_MSG2(level, msg, a, b) ((level) <= 1 ? std::printf(msg "\n", a, b) : 0)
#define PLAYER_MSG3(level, msg, a, b, c) ((level) <= 1 ? std::printf(msg "\n", a, b, c) : 0)
// NOLINTEND(cppcoreguidelines-macro-usage)
