#include "rainfall/errors/step_variance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/errors/gaussian_field.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

class FieldOfSites : public testing::Test {
 protected:
  explicit FieldOfSites(std::size_t gauges = 40) {
    for (std::size_t i = 0; i < gauges; ++i)
      places_.push_back({seeded_.uniform(0, 1), seeded_.uniform(0, 1)});
    sites_.emplace(places_, Metric::planar);
    variogram_.emplace(model_, 2);
  }
  /// One value a site.
  std::vector<double> draw(const GaussianField& field) {
    const std::vector<double> by_place = field.draw(seeded_);
    std::vector<double> readings(by_place.size());
    for (std::uint32_t s = 0; s < readings.size(); ++s) readings[s] = by_place[sites_->place_of(s)];
    return readings;
  }

  Seeded seeded_;
  std::vector<Point> places_;
  std::optional<Sites> sites_;
  const VariogramModel model_{VariogramModel::Shape::stable, 0, 1, 0.5, 1};
  std::optional<Variogram> variogram_;
};

// Of 4,000 fields of variance 9 the mean estimate is 9 within four standard errors, and estimates
// scatter as the degrees of freedom say, whoever is silent.
TEST_F(FieldOfSites, have_the_variance_that_near_differences_tell) {
  const GaussianField field(places_, [](double d) { return std::exp(-d / 0.5); });
  const StepVariance variance(*sites_, *variogram_);
  for (const double share_silent : {0.0, 0.3, 0.8}) {
    double sum = 0;
    double squares = 0;
    double degrees = 0;
    double count = 0;
    for (int round = 0; round < 4'000; ++round) {
      std::vector<double> readings = draw(field);
      for (double& r : readings) r = seeded_.uniform(0, 1) < share_silent ? silent : 3 * r + 100;
      const FieldVariance found = variance.of(readings);
      if (found.gauges < 5) continue;
      sum += found.variance / 9;
      squares += (found.variance / 9 - 1) * (found.variance / 9 - 1);
      degrees += found.degrees;
      ++count;
    }
    const double scatter = squares / count;
    EXPECT_NEAR(sum / count, 1, 4 * std::sqrt(scatter / count)) << share_silent;
    EXPECT_NEAR(scatter / (2 / (degrees / count)), 1, share_silent < 0.5 ? 0.15 : 0.6)
        << share_silent;
  }
}

TEST_F(FieldOfSites, have_none_below_five_gauges_or_where_all_read_the_same) {
  const StepVariance variance(*sites_, *variogram_);
  std::vector<double> readings(places_.size(), silent);
  for (std::size_t i = 0; i < 4; ++i) readings[9 * i] = static_cast<double>(i);
  EXPECT_TRUE(std::isnan(variance.of(readings).variance));
  EXPECT_EQ(variance.of(readings).gauges, 4u);
  readings[39] = 17;
  EXPECT_GT(variance.of(readings).variance, 0);
  const FieldVariance dry = variance.of(std::vector<double>(places_.size(), 0));
  EXPECT_TRUE(std::isnan(dry.variance));
  EXPECT_EQ(dry.gauges, 40u);
  EXPECT_TRUE(std::isnan(variance.of(std::vector<double>(places_.size(), silent)).variance));
}

TEST_F(FieldOfSites, have_a_variance_that_goes_with_the_square_of_the_unit) {
  const StepVariance variance(*sites_, *variogram_);
  std::vector<double> readings = draw(GaussianField(places_, [](double d) { return d == 0; }));
  const double once = variance.of(readings).variance;
  for (double& r : readings) r *= 25.4;
  EXPECT_NEAR(variance.of(readings).variance / once, 25.4 * 25.4, 1e-9);
}

// Student's two-sided 5 % points, from tables.
TEST(StepVariance, widens_as_student_says) {
  const double normal = 1.959964;
  EXPECT_NEAR(StepVariance::widening(3) * normal, 3.182446, 0.03);
  EXPECT_NEAR(StepVariance::widening(5) * normal, 2.570582, 0.003);
  EXPECT_NEAR(StepVariance::widening(10) * normal, 2.228139, 3e-4);
  EXPECT_NEAR(StepVariance::widening(30) * normal, 2.042272, 1e-5);
  EXPECT_NEAR(StepVariance::widening(120) * normal, 1.979930, 1e-5);
}

}  // namespace
}  // namespace thiessen
