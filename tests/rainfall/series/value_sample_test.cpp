#include "rainfall/series/value_sample.h"

#include <gtest/gtest.h>

#include <limits>

namespace thiessen {
namespace {

TEST(ValueSample, of_a_few_values_is_all_of_them_with_the_ends) {
  ValueSample sample;
  EXPECT_TRUE(sample.values().empty());
  for (const double value : {3.0, std::numeric_limits<double>::quiet_NaN(), 1.0, 2.0})
    sample.add(value);
  EXPECT_EQ(sample.values(), (std::vector<double>{3, 1, 2, 1, 3}));
}

// 100,000 values 0, 1, 2 ...: each fourth is kept, 25,000 of them.
TEST(ValueSample, of_many_values_is_even_and_has_the_ends) {
  ValueSample sample;
  for (int i = 0; i < 100'000; ++i) sample.add(i);
  const std::vector<double> values = sample.values();
  ASSERT_EQ(values.size(), 25'002U);
  for (std::size_t i = 0; i < 25'000; ++i) ASSERT_EQ(values[i], 4.0 * static_cast<double>(i));
  EXPECT_EQ(values[25'000], 0);
  EXPECT_EQ(values[25'001], 99'999);
}

}  // namespace
}  // namespace thiessen
