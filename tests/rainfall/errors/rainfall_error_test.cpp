#include "rainfall/errors/rainfall_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "basin/shapes.h"
#include "geometry/seeded.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/gaussian_field.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();
constexpr Yardstick plane{Metric::planar, 1, 0.1};

struct Table {
  std::vector<Station> stations;
  std::vector<std::vector<double>> steps;
};

/// 60 gauges in a square of 5, and one more at the place of the fourth, which reads something else.
Table random_table(Seeded& seeded, double share_silent) {
  Table table;
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i) points.push_back({seeded.uniform(0, 5), seeded.uniform(0, 5)});
  points.push_back(points[3]);
  for (std::size_t i = 0; i < points.size(); ++i)
    table.stations.push_back({std::to_string(i), points[i], 0});
  const GaussianField field(points, [](double d) { return std::exp(-d / 2); });
  for (int t = 0; t < 100; ++t) {
    std::vector<double> readings = field.draw(seeded);
    for (double& r : readings) {
      r = 50 + 10 * r + seeded.uniform(0, 3);
      if (seeded.uniform(0, 1) < share_silent) r = silent;
    }
    table.steps.push_back(std::move(readings));
  }
  return table;
}

StepSample sample_of(const Table& table) {
  StepSample sample(table.stations.size(), steps_for_errors(table.stations.size()));
  for (const auto& readings : table.steps) sample.add(readings);
  return sample;
}

std::vector<Basin> rectangles() {
  std::vector<Basin> basins;
  for (const auto& [low, high] : {std::pair{Point{1, 1}, Point{3, 3}},
                                  {{0.5, 2}, {4.5, 4}},
                                  {{2.2, 0.1}, {2.9, 1.3}},
                                  {{4, 4}, {7, 6}}})
    basins.push_back(shapes::basin({{shapes::rectangle(low, high), {}}}));
  return basins;
}

/// w'Rw - 2 w'r + r0 of a rectangle, on a fine grid; places are the gauges.
class Direct {
 public:
  Direct(const Basin& basin, const VariogramModel& model) : model_(model) {
    const Box box = shapes::box_of(basin.shape);
    constexpr int side = 40;
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        points_.push_back({box.low.x + box.width() * (i + 0.5) / side,
                           box.low.y + box.height() * (j + 0.5) / side});
      }
    }
    const double own = 0.5214 * std::sqrt(box.width() * box.height()) / side;
    for (const Point p : points_) {
      for (const Point q : points_) within_ += p == q ? 1 - model(own) : rho(p, q);
    }
    within_ /= static_cast<double>(points_.size() * points_.size());
  }

  double mean_square(const BasinWeights& weights, const Network& network) const {
    std::map<Point, double> w;
    for (const StationWeight& s : weights.stations)
      w[network.stations()[index(s.station)].position] += s.weight;
    double sum = within_;
    for (const auto& [p, wp] : w) {
      for (const auto& [q, wq] : w) sum += wp * wq * (p == q ? 1 : rho(p, q));
      double to_points = 0;
      for (const Point x : points_) to_points += rho(p, x);
      sum -= 2 * wp * to_points / static_cast<double>(points_.size());
    }
    return sum;
  }

 private:
  double rho(Point p, Point q) const { return 1 - model_(std::hypot(p.x - q.x, p.y - q.y)); }

  const VariogramModel& model_;
  std::vector<Point> points_;
  double within_ = 0;
};

// Whatever the policy, squares of standard errors are to each other as the block kriging variances
// of the weights that are told, computed from these alone and on another grid.
TEST(RainfallError, goes_with_the_block_kriging_variance_of_the_weights_of_the_step) {
  Seeded seeded;
  const Table table = random_table(seeded, 0.2);
  const Network network(table.stations, Metric::planar);
  const std::vector<Basin> basins = rectangles();
  const Weighing weighing(network, basins, plane);
  for (const Gaps gaps : {Gaps::retessellate, Gaps::renormalise, Gaps::strict}) {
    const ArealRainfall rainfall(weighing, {gaps, 2}, 1);
    const RainfallError error(rainfall, weighing, sample_of(table), 1);
    ASSERT_EQ(error.shortfall(), "");
    std::vector<Direct> direct;
    for (const Basin& basin : basins) direct.emplace_back(basin, error.variogram());
    for (std::size_t t = 0; t < 12; ++t) {
      const auto values = error.at(table.steps[t]);
      const auto weights = rainfall.weights_at(table.steps[t]);
      std::optional<double> ratio;
      for (std::size_t b = 0; b < basins.size(); ++b) {
        const double se = values[b].standard_error;
        ASSERT_EQ(std::isnan(se), std::isnan(values[b].rainfall));
        if (std::isnan(se)) continue;
        const double its = se * se / direct[b].mean_square(weights[b], network);
        if (ratio) {
          EXPECT_NEAR(its / *ratio, 1, 0.02);
        }
        if (!ratio) ratio = its;
      }
    }
  }
}

TEST(RainfallError, changes_no_value) {
  Seeded seeded;
  const Table table = random_table(seeded, 0.1);
  const Network network(table.stations, Metric::planar);
  const std::vector<Basin> basins = rectangles();
  const Weighing weighing(network, basins, plane);
  for (const Gaps gaps : {Gaps::retessellate, Gaps::renormalise, Gaps::strict}) {
    const ArealRainfall rainfall(weighing, {gaps}, 1);
    const RainfallError error(rainfall, weighing, sample_of(table), 1);
    for (const auto& readings : table.steps) {
      const auto with = error.at(readings);
      const auto without = rainfall.at(readings);
      for (std::size_t b = 0; b < basins.size(); ++b) {
        ASSERT_TRUE(with[b].rainfall == without[b].rainfall || std::isnan(without[b].rainfall));
        ASSERT_EQ(with[b].gauges, without[b].gauges);
        ASSERT_EQ(with[b].coverage, without[b].coverage);
        ASSERT_TRUE(std::isnan(without[b].standard_error));
      }
    }
  }
}

// To a bit: neither the order of the stations nor threads show, nor who asked before.
TEST(RainfallError, depends_on_the_readings_alone) {
  Seeded seeded;
  const Table table = random_table(seeded, 0.2);
  std::vector<std::size_t> order(table.stations.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), seeded.generator());
  Table shuffled;
  for (const std::size_t i : order) shuffled.stations.push_back(table.stations[i]);
  for (const auto& readings : table.steps) {
    auto& row = shuffled.steps.emplace_back();
    for (const std::size_t i : order) row.push_back(readings[i]);
  }
  const std::vector<Basin> basins = rectangles();
  const Network network(table.stations, Metric::planar);
  const Network other_network(shuffled.stations, Metric::planar);
  const Weighing weighing(network, basins, plane);
  const Weighing other_weighing(other_network, basins, plane);
  const ArealRainfall rainfall(weighing, {}, 1);
  const ArealRainfall other_rainfall(other_weighing, {}, 4);
  const RainfallError error(rainfall, weighing, sample_of(table), 1);
  const RainfallError other(other_rainfall, other_weighing, sample_of(shuffled), 4);
  for (std::size_t t = table.steps.size(); t-- > 0;) other.at(shuffled.steps[t]);
  for (std::size_t t = 0; t < table.steps.size(); ++t) {
    const auto a = error.at(table.steps[t]);
    const auto b = other.at(shuffled.steps[t]);
    for (std::size_t i = 0; i < basins.size(); ++i)
      ASSERT_EQ(a[i].standard_error, b[i].standard_error);
  }
}

TEST(RainfallError, has_no_figure_where_there_is_nothing_to_tell_it) {
  Seeded seeded;
  const Table table = random_table(seeded, 0);
  const Network network(table.stations, Metric::planar);
  const std::vector<Basin> basins = rectangles();
  const Weighing weighing(network, basins, plane);
  const ArealRainfall rainfall(weighing, {}, 1);
  const RainfallError error(rainfall, weighing, sample_of(table), 1);
  const auto at = [&](const std::vector<double>& readings) { return error.at(readings)[0]; };
  EXPECT_GT(at(table.steps[0]).standard_error, 0);
  EXPECT_TRUE(std::isnan(at(std::vector<double>(61, 0)).standard_error));
  EXPECT_EQ(at(std::vector<double>(61, 0)).rainfall, 0);
  std::vector<double> few(61, silent);
  for (const std::size_t s : {3u, 10u, 20u, 30u, 60u}) few[s] = static_cast<double>(s);
  // The fourth and the last are at one place.
  EXPECT_TRUE(std::isnan(at(few).standard_error));
  few[40] = 7;
  EXPECT_GT(at(few).standard_error, 0);
  EXPECT_TRUE(std::isnan(at(std::vector<double>(61, silent)).standard_error));

  Table nothing = table;
  nothing.steps.resize(4);
  const RainfallError none(rainfall, weighing, sample_of(nothing), 1);
  EXPECT_NE(none.shortfall(), "");
  EXPECT_TRUE(std::isnan(none.at(table.steps[0])[0].standard_error));
  EXPECT_EQ(none.at(table.steps[0])[0].rainfall, rainfall.at(table.steps[0])[0].rainfall);
}

// Where all readings are in another unit, so are the errors; in metres or kilometres they are the
// same.
TEST(RainfallError, is_in_the_unit_of_the_readings) {
  Seeded seeded;
  const Table table = random_table(seeded, 0.1);
  const auto errors = [&](double inch, double unit) {
    Table scaled = table;
    for (Station& s : scaled.stations) s.position = {s.position.x * unit, s.position.y * unit};
    for (auto& readings : scaled.steps) {
      for (double& r : readings) r /= inch;
    }
    std::vector<Basin> basins = rectangles();
    for (Basin& basin : basins) {
      for (Point& p : basin.shape[0].outer) p = {p.x * unit, p.y * unit};
    }
    const Network network(scaled.stations, Metric::planar);
    const Weighing weighing(network, basins, {Metric::planar, 1 / (unit * unit), 0.1});
    const ArealRainfall rainfall(weighing, {}, 1);
    const RainfallError error(rainfall, weighing, sample_of(scaled), 1);
    std::vector<double> all;
    for (const BasinRainfall& b : error.at(scaled.steps[0])) all.push_back(b.standard_error);
    return all;
  };
  const auto plain = errors(1, 1);
  const auto inches = errors(25.4, 1);
  const auto metres = errors(1, 1000);
  for (std::size_t b = 0; b < plain.size(); ++b) {
    EXPECT_NEAR(inches[b] * 25.4 / plain[b], 1, 1e-4);
    EXPECT_NEAR(metres[b] / plain[b], 1, 1e-3);
  }
}

}  // namespace
}  // namespace thiessen
