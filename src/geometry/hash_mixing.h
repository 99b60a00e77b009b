#pragma once

#include <cstdint>

namespace thiessen {

/// Mixes the bits of a number so that each of them is felt in all of the result, the lowest ones
/// too, which choose the place in a hash table. Law: different numbers stay different. Source: the
/// finalizer of A. Appleby's MurmurHash3.
constexpr std::uint64_t mixed_bits(std::uint64_t number) {
  number = (number ^ (number >> 33)) * 0xFF51AFD7ED558CCDu;
  number = (number ^ (number >> 33)) * 0xC4CEB9FE1A85EC53u;
  return number ^ (number >> 33);
}

}  // namespace thiessen
