#pragma once

#include <array>
#include <cstdint>

namespace ccmorse {

/// One block of random bits, a function of counter and key alone: Philox4x32-10 (J. Salmon et al.,
/// "Parallel random numbers: as easy as 1, 2, 3", SC 2011).
std::array<std::uint32_t, 4> Philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key);

/// Two words of random bits as a number in (0, 1), uniform: never 0, whose logarithm does not
/// exist.
double OpenUniform(std::uint32_t high, std::uint32_t low);

/// Two independent, normally distributed numbers of mean 0 and standard deviation 1 from a block of
/// random bits (Box and Muller); the same bits on every machine.
std::array<double, 2> GaussianPair(const std::array<std::uint32_t, 4>& bits);

}  // namespace ccmorse
