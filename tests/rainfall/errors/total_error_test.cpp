#include "rainfall/errors/total_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

BasinRainfall step(double rainfall, double error_of_step, double error_of_normals = 0) {
  BasinRainfall basin{rainfall, 0, 0};
  basin.error_of_step = error_of_step;
  basin.error_of_normals = error_of_normals;
  return basin;
}

// The double sum written out: errors of 1, 2, 3 and 4 with correlations of 0.5, 0.2 and then 0.1.
// Squares 30; lag 1: 2 + 6 + 12 = 20; lag 2: 3 + 8 = 11; lag 3: 4.
TEST(TotalError, is_the_double_sum_of_correlations_times_errors) {
  const ErrorCorrelation correlation{{0.5, 0.2}, 0.1};
  TotalError total;
  for (const double error : {1, 2, 3, 4}) total.add(step(10, error), 1, correlation);
  EXPECT_NEAR(total.standard_error(correlation),
              std::sqrt(30 + 2 * (0.5 * 20 + 0.2 * 11 + 0.1 * 4)), 1e-12);
}

TEST(TotalError, of_what_lasts_alone_is_the_sum_of_errors) {
  const ErrorCorrelation correlation{{}, 1};
  TotalError total;
  for (const double error : {1, 2, 3}) total.add(step(10, error), 1, correlation);
  EXPECT_NEAR(total.standard_error(correlation), 6, 1e-12);
}

// Values count three times: steps of 1 and 2 are independent, and normals err by 2 and 4 together.
TEST(TotalError, adds_up_what_normals_err_and_takes_the_factor_of_the_values) {
  const ErrorCorrelation correlation;
  TotalError total;
  total.add(step(10, 1, 2), 3, correlation);
  total.add(step(20, 2, 4), 3, correlation);
  EXPECT_NEAR(total.standard_error(correlation), 3 * std::hypot(std::sqrt(5), 6), 1e-12);
}

// A step without a value adds nothing, and the next is two steps from the one before; a dry step
// has an error of 0; a value whose error is not known leaves the total without one.
TEST(TotalError, counts_lags_in_steps_whether_they_have_values_or_not) {
  const ErrorCorrelation correlation{{0.5, 0.25}, 0};
  TotalError total;
  total.add(step(10, 2), 1, correlation);
  total.add(step(none, none), 1, correlation);
  total.add(step(10, 4), 1, correlation);
  total.add(step(0, 0), 1, correlation);
  EXPECT_NEAR(total.standard_error(correlation), std::sqrt(4 + 16 + 2 * 0.25 * 8), 1e-12);
  total.add(step(3, none), 1, correlation);
  EXPECT_TRUE(std::isnan(total.standard_error(correlation)));
}

TEST(TotalErrors, are_of_one_period_after_the_other) {
  TotalErrors errors(std::make_shared<const ErrorCorrelation>(ErrorCorrelation{{}, 1}));
  for (int period = 0; period < 2; ++period) {
    errors.begin(2);
    errors.add(std::vector<BasinRainfall>{step(1, 1), step(1, 5)}, 1);
    errors.add(std::vector<BasinRainfall>{step(1, 2), step(1, 6)}, 1);
    EXPECT_NEAR(errors.of(0), 3, 1e-12);
    EXPECT_NEAR(errors.of(1), 11, 1e-12);
  }
  TotalErrors no_errors(nullptr);
  no_errors.begin(2);
  no_errors.add(std::vector<BasinRainfall>{step(1, 1), step(1, 5)}, 1);
  EXPECT_TRUE(std::isnan(no_errors.of(0)));
}

}  // namespace
}  // namespace thiessen
