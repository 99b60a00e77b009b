#include "rainfall/errors/basin_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

using Shape = VariogramModel::Shape;

std::vector<Direction> grid(int side) {
  std::vector<Direction> points;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) points.push_back({(i + 0.5) / side, (j + 0.5) / side, 0});
  }
  return points;
}

// Known: in a unit square the mean distance from the centre is (sqrt 2 + ln (1 + sqrt 2)) / 6, and
// that of two points 0.521405; where the variogram is the distance, one gauge in the centre is off
// by twice the one less the other.
TEST(BasinError, of_a_gauge_in_the_middle_of_a_square_is_that_by_hand) {
  const Sites sites(std::vector<Point>{{0.5, 0.5}}, Metric::planar);
  const double far = 1e4;
  const Variogram variogram({Shape::stable, 0, far, far, 1}, 2);
  const BasinError error({{0, 1}}, grid(20), 1.0 / 20, sites, variogram);
  const double from_centre = (std::sqrt(2) + std::log(1 + std::sqrt(2))) / 6;
  EXPECT_NEAR(error.mean_square({}), 2 * from_centre - 0.521405433, 5e-4);
}

// Independent readings, and a basin's mean without any of their noise: their variance times the
// sum of the squares of the weights.
TEST(BasinError, of_gauges_that_know_nothing_of_each_other_is_that_of_their_mean) {
  const Sites sites(std::vector<Point>{{0.1, 0.5}, {0.9, 0.5}, {0.5, 3}}, Metric::planar);
  const Variogram variogram({Shape::stable, 0.8, 0, 1, 1}, 4);
  const BasinError error({{0, 0.5}, {1, 0.3}, {2, 0.2}}, grid(8), 1.0 / 8, sites, variogram);
  EXPECT_NEAR(error.mean_square({}), 0.8 * (0.25 + 0.09 + 0.04), 1e-13);
  // The third falls silent and the first takes its ground; then it is left out, and the others
  // scaled.
  EXPECT_NEAR(error.mean_square(std::vector<SiteWeight>{{0, 0.2}, {2, -0.2}}), 0.8 * (0.49 + 0.09),
              1e-13);
  EXPECT_NEAR(error.mean_square(std::vector<SiteWeight>{{2, -0.2}}), 0.8 * (0.25 + 0.09) / 0.64,
              1e-13);
}

class RandomBasinError : public testing::Test {
 protected:
  RandomBasinError() {
    std::vector<Point> places;
    for (int i = 0; i < 60; ++i)
      places.push_back({seeded_.uniform(-0.5, 1.5), seeded_.uniform(-0.5, 1.5)});
    sites_.emplace(places, Metric::planar);
    double sum = 0;
    for (std::uint32_t s = 5; s < 30; ++s) {
      full_.push_back({s, seeded_.uniform(0, 1)});
      sum += full_.back().weight;
    }
    for (SiteWeight& w : full_) w.weight /= sum;
  }

  /// w'Rw - 2 w'r + r0, with the correlations themselves.
  double by_correlations(const std::vector<SiteWeight>& change, const Variogram& variogram,
                         double side) const {
    std::vector<double> w(sites_->size(), 0);
    for (const SiteWeight& f : full_) w[f.site] += f.weight;
    for (const SiteWeight& c : change) w[c.site] += c.weight;
    double sum = 0;
    for (const double weight : w) sum += weight;
    const auto rho = [&](double square) { return 1 - variogram.at_square(square); };
    double result = 0;
    const auto n = static_cast<double>(points_.size());
    for (std::uint32_t i = 0; i < w.size(); ++i) {
      for (std::uint32_t j = 0; j < w.size(); ++j) {
        const double r = i == j ? 1 : rho(square_distance((*sites_)[i], (*sites_)[j]));
        result += w[i] / sum * w[j] / sum * r;
      }
      for (const Direction p : points_)
        result -= 2 * w[i] / sum * rho(square_distance((*sites_)[i], p)) / n;
    }
    const double own = 0.521405433164721 * side;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      for (std::size_t l = 0; l < points_.size(); ++l)
        result += rho(k == l ? own * own : square_distance(points_[k], points_[l])) / n / n;
    }
    return result;
  }

  Seeded seeded_;
  std::optional<Sites> sites_;
  std::vector<SiteWeight> full_;
  const std::vector<Direction> points_ = grid(12);
};

// Changed weights, and weights that add up to less than 1, as where silent gauges are left out.
TEST_F(RandomBasinError, is_the_form_with_correlations_to_1e_12) {
  for (const VariogramModel& model : {VariogramModel{Shape::stable, 0.1, 0.9, 0.5, 1},
                                      {Shape::stable, 0, 1, 3, 1.9},
                                      {Shape::spherical, 0.3, 0.6, 1, 1}}) {
    const Variogram variogram(model, 4);
    const BasinError error(full_, points_, 1.0 / 12, *sites_, variogram);
    EXPECT_NEAR(error.mean_square({}), by_correlations({}, variogram, 1.0 / 12), 1e-12);
    for (int round = 0; round < 200; ++round) {
      std::set<std::uint32_t> changed;
      for (std::uint64_t k = seeded_.below(12); k > 0; --k)
        changed.insert(static_cast<std::uint32_t>(seeded_.below(60)));
      std::vector<SiteWeight> change;
      for (const std::uint32_t s : changed) change.push_back({s, seeded_.uniform(-0.02, 0.05)});
      ASSERT_NEAR(error.mean_square(change),
                  std::max(0.0, by_correlations(change, variogram, 1.0 / 12)), 1e-12);
    }
  }
}

}  // namespace
}  // namespace thiessen
