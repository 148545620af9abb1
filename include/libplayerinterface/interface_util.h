#pragma once

// Names and codes of Player's interfaces (specs: player.md B.7). Any thread.

#include <cstdint>

/// Name of the interface `code`: 6 is "laser"; "unknown" when there is none. Never ends.
const char* interf_to_str(std::uint16_t code);
/// Code of the interface `name`: "laser" is 6; 0xFFFF when there is none.
std::uint16_t str_to_interf(const char* name);
/// Name of a message type: 1 is "data"; "unknown" when there is none.
const char* msgtype_to_str(std::uint32_t type);
