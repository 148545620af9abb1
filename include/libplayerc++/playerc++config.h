#pragma once

// What this build of the library can do, under Player's names (specs: player.md A.1): threads and
// read signals, both without Boost.
// NOLINTBEGIN(cppcoreguidelines-macro-usage)
#ifndef HAVE_BOOST_THREAD
#define HAVE_BOOST_THREAD 1
#endif
#ifndef HAVE_BOOST_SIGNALS
#define HAVE_BOOST_SIGNALS 1
#endif
// NOLINTEND(cppcoreguidelines-macro-usage)
