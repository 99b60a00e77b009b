#include "rainfall/leaving_out/dated_sample.h"

#include <gtest/gtest.h>

#include <vector>

namespace thiessen {
namespace {

TEST(DatedSample, dates_stay_with_their_steps) {
  for (const int steps : {1, 4, 5, 9, 100, 1000}) {
    DatedSample sample(1, 4);
    for (int t = 0; t < steps; ++t)
      sample.add(std::vector<double>{t * 1.0}, static_cast<std::size_t>(t % 12), t);
    EXPECT_EQ(sample.seen(), static_cast<std::size_t>(steps));
    ASSERT_LE(sample.steps(), 4u);
    for (std::size_t i = 0; i < sample.steps(); ++i) {
      const auto t = static_cast<int>(i * sample.spacing());
      EXPECT_EQ(sample.readings(i)[0], t);
      EXPECT_EQ(sample.year(i), t);
      EXPECT_EQ(sample.month(i), static_cast<std::size_t>(t % 12));
    }
  }
}

TEST(DatedSample, by_years) {
  DatedSample sample(1, 10);
  for (const std::optional<int> year : {std::optional<int>(2001), {}, {1999}, {2001}, {1999}})
    sample.add(std::vector<double>{1}, {}, year);
  EXPECT_EQ(sample.by_years(), (std::vector<std::size_t>{2, 4, 0, 3, 1}));
  EXPECT_TRUE(sample.has_sums_of_years());
}

TEST(DatedSample, of_years_as_steps_has_no_sums) {
  DatedSample sample(1, 10);
  for (const int year : {2001, 2002}) sample.add(std::vector<double>{1}, {}, year);
  sample.add(std::vector<double>{1}, {}, {});
  sample.add(std::vector<double>{1}, {}, {});
  EXPECT_FALSE(sample.has_sums_of_years());
}

}  // namespace
}  // namespace thiessen
