#include "geometry/equal_points.h"

#include <bit>
#include <cstddef>

#include "geometry/hash_mixing.h"

namespace thiessen {
namespace {

// Adding 0 makes 0 of -0.
std::uint64_t hash_of(Point p) {
  const std::uint64_t x = mixed_bits(std::bit_cast<std::uint64_t>(p.x + 0.0));
  return mixed_bits(x ^ std::bit_cast<std::uint64_t>(p.y + 0.0));
}

}  // namespace

// A table with open addressing, no more than half full, holds the number of the first of each.
std::vector<std::uint32_t> first_equal_points(std::span<const Point> points) {
  constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::vector<std::uint32_t> table(std::bit_ceil(2 * points.size() + 1), none);
  const std::size_t mask = table.size() - 1;
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    std::size_t at = hash_of(points[i]) & mask;
    while (table[at] != none && points[table[at]] != points[i]) at = (at + 1) & mask;
    if (table[at] == none) table[at] = i;
    first[i] = table[at];
  }
  return first;
}

}  // namespace thiessen
