#pragma once

// What libCCMorse and libccmorse-sim say to each other: a C interface, because the client library
// opens the simulator's with dlopen() and neither may depend on how the other was built. The
// simulator's library serves its protocols over a socket within the program, so that all that a
// client says and hears is what it would be over TCP.

/// The version of this interface; libraries of different ones do not work together.
#define CCMORSE_SIM_ABI 1

extern "C" {

/// A simulation with a thread of its own.
struct CcmorseSim;

/// Takes the text of an error, which is good until it returns.
using CcmorseSimTell = void (*)(void* context, const char* text);

/// CCMORSE_SIM_ABI of the library.
int ccmorse_sim_abi() noexcept;

/// Makes the simulation of "SCENARIO?option=value&..." (docs/player.md lists the options); its time
/// does not run yet. nullptr after `tell` was told why: the text that `ccmorse run` prints. Any
/// thread.
CcmorseSim* ccmorse_sim_open(const char* text, CcmorseSimTell tell, void* context) noexcept;

/// Connects a client that will speak `protocol`, "morse" or "player"; the latter with `robot`, ""
/// being the first. The client's end: a non-blocking stream socket, which the caller closes; -1
/// after `tell` was told why not. Time runs from the first call on. Any thread.
int ccmorse_sim_connect(CcmorseSim* simulation, const char* protocol, const char* robot,
                        CcmorseSimTell tell, void* context) noexcept;

/// Ends the simulation and frees it: `at_once` or, as when `ccmorse run` gets SIGTERM, when what
/// clients have sent is done, which takes 2 s at most where one is still connected. Then its record
/// and its report are complete. No other call may be under way.
void ccmorse_sim_close(CcmorseSim* simulation, int at_once) noexcept;
}
