#include "rainfall/series/held_totals.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace thiessen {
namespace {

/// The totals that are added as period `n`.
std::array<BasinTotal, 3> period(std::size_t n) {
  const auto value = static_cast<double>(n);
  return {BasinTotal{value, n}, BasinTotal{-value, 2 * n}, BasinTotal{0.5 * value, 0}};
}

void add_and_take(HeldTotals totals, std::size_t periods) {
  for (std::size_t n = 0; n < periods; ++n) totals.add(period(n));
  for (std::size_t n = 0; n < periods; ++n) {
    std::array<BasinTotal, 3> taken{};
    totals.take(taken);
    for (std::size_t b = 0; b < taken.size(); ++b) {
      ASSERT_EQ(taken[b].rainfall, period(n)[b].rainfall) << n;
      ASSERT_EQ(taken[b].missing, period(n)[b].missing) << n;
    }
  }
}

TEST(HeldTotals, come_back_as_they_were_from_memory) {
  add_and_take(HeldTotals(), 1000);
}

TEST(HeldTotals, come_back_as_they_were_from_a_file) {
  add_and_take(HeldTotals(100), 1000);
  add_and_take(HeldTotals(1), 7);  // less memory than a period
}

}  // namespace
}  // namespace thiessen
