// What the standard errors claim, against simulated fields whose true means over the basins are
// known: the share of these within 1.96 standard errors of the areal rainfall. The correlation is
// fitted to the simulated series of the gauges, never taken from the truth.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "basin/shapes.h"
#include "geometry/seeded.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/gaussian_field.h"
#include "rainfall/errors/rainfall_error.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

struct Setting {
  const char* name;
  GaussianField::Correlation correlation;
  double nugget = 0;  ///< share of the variance that is each gauge's own
  std::size_t gauges = 30;
  double share_silent = 0;  ///< at random
  Gaps gaps = Gaps::retessellate;
  std::optional<double> level = std::nullopt;  ///< what is above it falls, and nothing else
  Metric metric = Metric::planar;              ///< geodesic: a degree is the unit, at the equator
};

GaussianField::Correlation stable(double range, double exponent) {
  return [=](double d) { return std::exp(-std::pow(d / range, exponent)); };
}
GaussianField::Correlation spherical(double range) {
  return [=](double d) {
    const double u = d / range;
    return u < 1 ? 1 - u * (1.5 - 0.5 * u * u) : 0;
  };
}

constexpr int side = 20;  // of the grid of points that the truth is a mean over

/// Five basins in the unit square: its quarters, and one in its middle.
struct Rectangle {
  int left, bottom, right, top;
};
constexpr Rectangle rectangles[] = {
    {0, 0, 10, 10}, {10, 0, 20, 10}, {0, 10, 10, 20}, {10, 10, 20, 20}, {5, 5, 15, 15}};

std::vector<Basin> basins_of_rectangles() {
  std::vector<Basin> basins;
  for (const Rectangle& r : rectangles) {
    const auto at = [](int i) { return static_cast<double>(i) / side; };
    basins.push_back(shapes::basin(
        {{shapes::rectangle({at(r.left), at(r.bottom)}, {at(r.right), at(r.top)}), {}}}));
  }
  return basins;
}

/// What falls of a value.
double rain(double value, const std::optional<double>& level) {
  return level ? std::max(0.0, value - *level) : value;
}

double mean_of_grid(const std::vector<double>& field, std::size_t first, const Rectangle& r,
                    const std::optional<double>& level) {
  double sum = 0;
  for (int i = r.left; i < r.right; ++i) {
    for (int j = r.bottom; j < r.top; ++j)
      sum += rain(field[first + static_cast<std::size_t>(i * side + j)], level);
  }
  return sum / ((r.right - r.left) * (r.top - r.bottom));
}

struct Count {
  double within = 0;
  double bars = 0;
  double empty = 0;
  double all = 0;

  double coverage() const { return within / bars; }
};

struct Step {
  std::vector<double> readings;
  std::vector<double> truth;  // by basin
};

std::vector<Step> simulate(Seeded& seeded, const Setting& setting, const std::vector<Point>& gauges,
                           std::size_t steps) {
  std::vector<Point> points = gauges;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) points.push_back({(i + 0.5) / side, (j + 0.5) / side});
  }
  const GaussianField field(points, setting.correlation);
  std::normal_distribution<double> normal;
  std::vector<Step> all(steps);
  for (Step& step : all) {
    std::vector<double> values = field.draw(seeded);
    for (double& value : values) value *= std::sqrt(1 - setting.nugget);
    for (std::size_t g = 0; g < gauges.size(); ++g) {
      const double reading = values[g] + std::sqrt(setting.nugget) * normal(seeded.generator());
      const bool reports = seeded.uniform(0, 1) >= setting.share_silent;
      step.readings.push_back(reports ? 7 * rain(reading, setting.level) : silent);
    }
    for (const Rectangle& r : rectangles)
      step.truth.push_back(7 * mean_of_grid(values, gauges.size(), r, setting.level));
  }
  return all;
}

void count(const std::vector<Step>& series, const RainfallError& error, Count& all, Count& wet) {
  for (const Step& step : series) {
    const auto rainfall = error.at(step.readings);
    for (std::size_t b = 0; b < rainfall.size(); ++b) {
      if (std::isnan(rainfall[b].rainfall)) continue;
      ++all.all;
      if (std::isnan(rainfall[b].standard_error)) {
        ++all.empty;
        continue;
      }
      const double off = std::abs(rainfall[b].rainfall - step.truth[b]);
      const bool within = off <= 1.96 * rainfall[b].standard_error;
      all.within += within;
      ++all.bars;
      if (!(rainfall[b].rainfall > 0)) continue;
      wet.within += within;
      ++wet.bars;
    }
  }
}

struct Coverage {
  Count all;
  Count wet;
};

Coverage coverage_of(Seeded& seeded, const Setting& setting, int networks, std::size_t steps) {
  const std::vector<Basin> basins = basins_of_rectangles();
  Coverage result;
  for (int i = 0; i < networks; ++i) {
    std::vector<Station> stations;
    std::vector<Point> gauges;
    for (std::size_t g = 0; g < setting.gauges; ++g) {
      gauges.push_back({seeded.uniform(-0.1, 1.1), seeded.uniform(-0.1, 1.1)});
      stations.push_back({std::to_string(g), gauges.back(), 0});
    }
    const Network network(stations, setting.metric);
    const Weighing weighing(network, basins, {setting.metric, 1, 0.1});
    const ArealRainfall rainfall(weighing, {setting.gaps}, 1);
    const std::vector<Step> series = simulate(seeded, setting, gauges, steps);
    StepSample sample(gauges.size(), steps_for_errors(gauges.size()));
    for (const Step& step : series) sample.add(step.readings);
    const RainfallError error(rainfall, weighing, sample, 1);
    EXPECT_EQ(error.shortfall(), "");
    count(series, error, result.all, result.wet);
  }
  return result;
}

const Setting settings[] = {
    {"exponential, short", stable(0.1, 1)},
    {"exponential", stable(0.4, 1)},
    {"exponential, long", stable(2, 1)},
    {"exponential with nugget", stable(0.4, 1), 0.1},
    {"Gaussian", stable(0.25, 2)},
    {"Gaussian with nugget", stable(0.3, 2), 0.1},
    {"Gaussian, long, with nugget", stable(1, 2), 0.05},
    {"spherical", spherical(0.6)},
    {"spherical, long", spherical(1.5)},
    {"spherical with nugget", spherical(0.6), 0.2},
    {"stable 1.5", stable(0.5, 1.5)},
    {"exponential, 15 gauges", stable(0.4, 1), 0, 15},
    {"spherical with nugget, 15 gauges", spherical(0.6), 0.1, 15},
    {"exponential, 80 gauges", stable(0.4, 1), 0, 80},
    {"exponential, 20 % silent", stable(0.4, 1), 0, 40, 0.2},
    {"spherical with nugget, 50 % silent", spherical(0.6), 0.1, 60, 0.5},
    {"exponential, 20 % silent, renormalised", stable(0.4, 1), 0, 40, 0.2, Gaps::renormalise},
    {"exponential, 2 % silent, strict", stable(0.4, 1), 0, 30, 0.02, Gaps::strict},
    {"stable 1.5 on the Earth, 20 % silent", stable(0.5, 1.5), 0.05, 40, 0.2, Gaps::retessellate,
     std::nullopt, Metric::geodesic},
};

TEST(RainfallErrorCoverage, of_stationary_normal_fields_is_93_to_97_percent) {
  Seeded seeded;
  for (const Setting& setting : settings) {
    SCOPED_TRACE(setting.name);
    const Coverage c = coverage_of(seeded, setting, 8, 400);
    std::printf("%-42s %5.2f %%\n", setting.name, 100 * c.all.coverage());
    EXPECT_GE(c.all.coverage(), 0.93);
    EXPECT_LE(c.all.coverage(), 0.97);
    EXPECT_EQ(c.all.empty, 0);
  }
}

// Rain that falls here and not there: an exponential normal field, of which what is above a level
// falls. Bars hold less than they claim, and the less the more gauges are dry: the bounds are what
// was measured, a percent to each side, for tests/README.md to say. Steps at which no gauge has
// rain have no figure.
TEST(RainfallErrorCoverage, of_intermittent_fields_is_what_was_measured) {
  Seeded seeded;
  struct Measured {
    double level;
    double dry;  ///< share of the readings that are 0
    double coverage;
    double coverage_of_wet;  ///< of values above 0
  };
  for (const Measured& measured : {Measured{0, 0.50, 0.93, 0.93},
                                   {0.5, 0.69, 0.914, 0.907},
                                   {1, 0.84, 0.90, 0.88},
                                   {1.5, 0.93, 0.892, 0.85}}) {
    const Setting setting{"", stable(0.4, 1), 0, 30, 0, Gaps::retessellate, measured.level};
    const Coverage c = coverage_of(seeded, setting, 16, 400);
    std::printf("%2.0f %% dry: %5.2f %%; of values above 0 %5.2f %%; of %2.0f %% no figure\n",
                100 * measured.dry, 100 * c.all.coverage(), 100 * c.wet.coverage(),
                100 * c.all.empty / c.all.all);
    EXPECT_NEAR(c.all.coverage(), measured.coverage, 0.012);
    EXPECT_NEAR(c.wet.coverage(), measured.coverage_of_wet, 0.015);
  }
}

}  // namespace
}  // namespace thiessen
