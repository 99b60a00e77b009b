#include "rainfall/methods/natural_weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/textbook.h"

namespace thiessen {
namespace {

/// In the plane, by the gauges' order; no weights outside the hull.
class Network2 {
 public:
  explicit Network2(std::vector<Point> gauges)
      : gauges_(std::move(gauges)), natural_(charted(gauges_), ChartKind::plane) {}

  std::vector<double> at(Point p) {
    std::vector<NaturalWeight> found;
    if (!natural_.find({p, {}}, found)) return {};
    std::vector<double> weights(gauges_.size(), 0);
    for (const NaturalWeight& w : found) {
      for (std::size_t i = 0; i < gauges_.size(); ++i) {
        if (natural_.numbers()[i] == w.gauge) weights[i] += w.weight;
      }
    }
    return weights;
  }
  const std::vector<Point>& gauges() const { return gauges_; }
  NaturalWeights& natural() { return natural_; }

  /// How far the weighted positions are off the point, and the weights' sum off 1, by the largest
  /// distance between two gauges; nothing outside the hull.
  std::optional<double> identity_error(Point p) {
    const std::vector<double> weights = at(p);
    if (weights.empty()) return {};
    long double x = 0;
    long double y = 0;
    long double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      EXPECT_GE(weights[i], 0);
      x += static_cast<long double>(weights[i]) * (static_cast<long double>(gauges_[i].x) - p.x);
      y += static_cast<long double>(weights[i]) * (static_cast<long double>(gauges_[i].y) - p.y);
      sum += static_cast<long double>(weights[i]);
    }
    Box box;
    for (const Point g : gauges_) box.take_in(g);
    const double size = std::max(box.width(), box.height());
    return std::max(static_cast<double>(std::hypot(x, y)) / size,
                    static_cast<double>(std::abs(sum - 1)));
  }

 private:
  static std::vector<ChartPoint> charted(const std::vector<Point>& gauges) {
    std::vector<ChartPoint> points;
    for (const Point p : gauges) points.push_back({p, {}});
    return points;
  }
  std::vector<Point> gauges_;
  NaturalWeights natural_;
};

double chow(Point p) {
  std::vector<Point> gauges;
  for (const Station& station : textbook::stations()) gauges.push_back(station.position);
  Network2 network(gauges);
  const std::vector<double> weights = network.at(p);
  double value = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) value += weights[i] * textbook::readings()[i];
  return value;
}

// By fractions.
TEST(NaturalWeights, of_the_textbook) {
  EXPECT_NEAR(chow({1, 1}), 980956849.0 / 13746548, 1e-12);
  EXPECT_NEAR(chow({-2, 1}), 167761031.0 / 2371737, 1e-12);
  EXPECT_NEAR(chow({1, -4}), 142654.0 / 2153, 1e-12);
}

// The middle of a square of four, and of a lattice.
TEST(NaturalWeights, of_a_square_are_bilinear_in_its_middle) {
  Network2 square({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  for (const double w : square.at({1, 1})) EXPECT_DOUBLE_EQ(w, 0.25);
  std::vector<Point> lattice;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) lattice.push_back({i * 2.0, j * 2.0});
  }
  Network2 network(lattice);
  const auto weights = network.at({5, 5});
  EXPECT_EQ(std::count_if(weights.begin(), weights.end(), [](double w) { return w > 0; }), 4);
  for (const int i : {14, 15, 20, 21})
    EXPECT_NEAR(weights[static_cast<std::size_t>(i)], 0.25, 1e-15);
}

std::vector<Point> scattered(Seeded& seeded, std::size_t count, Point low, double size) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({low.x + seeded.uniform(0, size), low.y + seeded.uniform(0, size)});
  return points;
}

TEST(NaturalWeights, give_back_the_point) {
  Seeded seeded;
  double worst = 0;
  std::size_t inside = 0;
  const auto look_at = [&](Network2& network, Point p) {
    const auto error = network.identity_error(p);
    if (!error) return;
    ++inside;
    worst = std::max(worst, *error);
    ASSERT_LT(*error, 1e-12) << p.x << ' ' << p.y;
  };
  for (std::uint64_t round = 0; round < Seeded::rounds(60); ++round) {
    const double size = std::pow(10, seeded.uniform(-3, 6));
    const Point low{seeded.uniform(-1e6, 1e6) * (round % 2 == 0),
                    seeded.uniform(0, 5e6) * (round % 3 == 0)};
    const double unit = std::max(size, 1e-5 * std::hypot(low.x, low.y));
    std::vector<Point> gauges = scattered(seeded, 3 + seeded.below(60), low, unit);
    if (round % 5 == 1) {  // a lattice
      for (Point& p : gauges) {
        p = {low.x + std::round(8 * (p.x - low.x) / unit) * unit / 8,
             low.y + std::round(8 * (p.y - low.y) / unit) * unit / 8};
      }
    }
    if (round % 5 == 2) {  // two roads
      for (std::size_t i = 0; i < gauges.size(); ++i) {
        gauges[i].x = low.x + (i % 2 == 0 ? 0 : unit / 7) + 1e-3 * (gauges[i].x - low.x);
      }
    }
    std::sort(gauges.begin(), gauges.end());
    gauges.erase(std::unique(gauges.begin(), gauges.end()), gauges.end());
    Network2 network(gauges);
    const auto any = [&] { return gauges[seeded.below(gauges.size())]; };
    for (int i = 0; i < 100; ++i) {
      look_at(network, scattered(seeded, 1, low, unit).front());
      const Point a = any();
      const Point b = any();
      const Point c = any();
      // Near a gauge, on and near a line between two, near the middle of three's circle.
      const double near = unit * std::pow(10, seeded.uniform(-12, -1));
      look_at(network, {a.x + near * seeded.uniform(-1, 1), a.y + near * seeded.uniform(-1, 1)});
      const double t = seeded.uniform(0, 1);
      const Point on{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      look_at(network, on);
      look_at(network, {on.x + near * seeded.uniform(-1, 1), on.y + near * seeded.uniform(-1, 1)});
      look_at(network, {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
    }
  }
  EXPECT_GT(inside, 10'000u);
  EXPECT_LT(worst, 1e-12);
}

TEST(NaturalWeights, outside_the_hull_there_are_none) {
  Network2 network({{0, 0}, {4, 0}, {0, 4}});
  EXPECT_TRUE(network.at({3, 3}).empty());
  EXPECT_TRUE(network.at({-1e-300, 1}).empty());
  EXPECT_FALSE(network.at({1, 1}).empty());
}

TEST(NaturalWeights, on_the_hull_they_are_linear) {
  Network2 network({{0, 0}, {4, 0}, {0, 4}, {1, 1}, {8, 0}});
  EXPECT_EQ(network.at({1, 0}), (std::vector<double>{0.75, 0.25, 0, 0, 0}));
  EXPECT_EQ(network.at({5, 0}), (std::vector<double>{0, 0.75, 0, 0, 0.25}));
  EXPECT_EQ(network.at({0, 3}), (std::vector<double>{0.25, 0, 0.75, 0, 0}));
  // That is what they tend to.
  const auto near = network.at({1, 1e-9});
  EXPECT_NEAR(near[0], 0.75, 1e-8);
  EXPECT_NEAR(near[1], 0.25, 1e-8);
}

TEST(NaturalWeights, at_a_gauge_it_has_all) {
  Seeded seeded;
  Network2 network(scattered(seeded, 40, {5e5, 4e6}, 1e4));
  for (std::size_t i = 0; i < network.gauges().size(); ++i) {
    const auto weights = network.at(network.gauges()[i]);
    ASSERT_EQ(weights.size(), 40u);
    EXPECT_EQ(weights[i], 1);
  }
}

TEST(NaturalWeights, gauges_on_a_line_are_linear_along_it) {
  Network2 line({{0, 0}, {4, 4}, {2, 2}});
  EXPECT_EQ(line.at({1, 1}), (std::vector<double>{0.5, 0, 0.5}));
  EXPECT_EQ(line.at({4, 4}), (std::vector<double>{0, 1, 0}));
  EXPECT_TRUE(line.at({5, 5}).empty());
  EXPECT_TRUE(line.at({1, 1.5}).empty());
  Network2 two({{0, 0}, {4, 0}});
  EXPECT_EQ(two.at({1, 0}), (std::vector<double>{0.75, 0.25}));
  EXPECT_TRUE(two.at({1, 1}).empty());
  Network2 one({{3, 3}});
  EXPECT_EQ(one.at({3, 3}), (std::vector<double>{1}));
  EXPECT_TRUE(one.at({3, 4}).empty());
}

// As a network that never had them; and afterwards as before.
TEST(NaturalWeights, without_some_gauges_they_are_the_others) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(40); ++round) {
    std::vector<Point> gauges = scattered(seeded, 30, {0, 0}, 8);
    if (round % 2 == 0) {
      for (Point& p : gauges) p = {std::round(p.x), std::round(p.y)};
      std::sort(gauges.begin(), gauges.end());
      gauges.erase(std::unique(gauges.begin(), gauges.end()), gauges.end());
    }
    Network2 network(gauges);
    std::vector<PointId> silent;
    std::vector<Point> rest;
    const double share = seeded.uniform(0, 1);
    for (std::size_t i = 0; i < gauges.size(); ++i) {
      if (seeded.uniform(0, 1) < share) {
        silent.push_back(network.natural().numbers()[i]);
      } else {
        rest.push_back(gauges[i]);
      }
    }
    Network2 others(rest);
    const auto points = scattered(seeded, 50, {0, 0}, 8);
    std::vector<std::vector<double>> before;
    for (const Point p : points) before.push_back(network.at(p));
    network.natural().without(silent, [&] {
      for (const Point p : points) {
        const auto weights = network.at(p);
        const auto expected = others.at(p);
        ASSERT_EQ(weights.empty(), expected.empty());
        for (std::size_t i = 0, k = 0; i < weights.size(); ++i) {
          const bool is_silent = k == rest.size() || rest[k] != gauges[i];
          EXPECT_NEAR(weights[i], is_silent ? 0 : expected[k++], 1e-13);
        }
      }
    });
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(network.at(points[i]), before[i]);
  }
}

}  // namespace
}  // namespace thiessen
