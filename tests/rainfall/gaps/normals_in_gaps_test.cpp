// What silent gauges leave counts by the normals of the very ground: a step with silent gauges has
// the value of a network without them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "rainfall/areal_rainfall.h"
#include "rainfall/gaps/gappy_study.h"
#include "rainfall/normals/plane_raster.h"
#include "rainfall/normals/uniform_normals.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double hill(double x, double y, std::size_t month) {
  return 500 + 60 * x + 200 * std::sin(2 * y + static_cast<double>(month)) + 90 * std::cos(5 * x);
}
/// The same with holes, of which some are larger than cells.
double torn(double x, double y, std::size_t month) {
  return std::fmod(3 * x + 7 * y, 11) < 3 || (x > 30 && y > 30) ? none : hill(x, y, month);
}

/// A study of gappy_study.h on a raster of 50 x 50 pixels.
gappy::Study on_raster(Seeded& seeded) {
  gappy::Study small = gappy::random_study(seeded);
  std::vector<Station> stations = small.network.stations();
  for (Station& station : stations)
    station.position = {10 * station.position.x, 10 * station.position.y};
  std::vector<Basin> basins = small.basins;
  for (Basin& basin : basins) {
    for (Polygon& part : basin.shape) {
      for (Point& p : part.outer) p = {10 * p.x, 10 * p.y};
    }
  }
  return {stations, basins};
}

void give_normals(gappy::Study& study, bool is_torn, std::size_t months) {
  plane_raster::Raster raster{51, 51, hill, months};
  if (is_torn) raster.value = torn;
  study.weighing.take_normals(plane_raster::normals_of(raster, hill, study.network, study.basins));
}

std::vector<double> without_nan(const std::vector<double>& readings) {
  std::vector<double> rest;
  for (const double reading : readings) {
    if (!std::isnan(reading)) rest.push_back(reading);
  }
  return rest;
}

// Law: retessellated, a step is the same as a network without the gauges that are silent.
TEST(NormalsInGaps, of_silent_gauges_are_those_of_a_network_without_them) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(6); ++round) {
    for (const bool is_torn : {false, true}) {
      gappy::Study study = on_raster(seeded);
      give_normals(study, is_torn, 1);
      const ArealRainfall rainfall(study.weighing, {}, 1);
      for (const double share : {0.05, 0.4, 0.9}) {
        const auto readings = gappy::readings_of(seeded, study, share);
        if (without_nan(readings).empty()) continue;
        gappy::Study rest = study.without_silent(readings);
        give_normals(rest, is_torn, 1);
        const auto found = rainfall.at(readings);
        const auto expected = ArealRainfall(rest.weighing, {}, 1).at(without_nan(readings));
        const auto weights = rainfall.weights_at(readings);
        for (std::size_t b = 0; b < found.size(); ++b) {
          EXPECT_NEAR(found[b].rainfall, expected[b].rainfall, 1e-9 * expected[b].rainfall);
          double sum = 0;
          for (const StationWeight& s : weights[b].stations)
            sum += s.weight * s.factor * readings[index(s.station)];
          EXPECT_NEAR(sum, found[b].rainfall, 1e-11 * sum);
        }
      }
    }
  }
}

// Law: where no gauge is silent all policies agree, and the value is the sum of weight x factor x
// reading.
TEST(NormalsInGaps, of_all_gauges_are_the_same_by_every_policy) {
  Seeded seeded;
  gappy::Study study = on_raster(seeded);
  give_normals(study, false, 1);
  const auto readings = gappy::readings_of(seeded, study, 0);
  const auto weights = study.weighing.weights(ReportingStations(readings.size(), true), 1);
  for (const Gaps gaps : all_gaps) {
    const auto values = ArealRainfall(study.weighing, {.gaps = gaps}, 1).at(readings);
    for (std::size_t b = 0; b < values.size(); ++b) {
      double sum = 0;
      for (const StationWeight& s : weights[b].stations)
        sum += s.weight * s.factor * readings[index(s.station)];
      EXPECT_NEAR(values[b].rainfall, sum, 1e-12 * sum);
    }
  }
}

// Normals that are one number everywhere change no bit of any value, whatever is silent.
TEST(NormalsInGaps, that_are_the_same_everywhere_change_no_bit) {
  Seeded seeded;
  gappy::Study study = on_raster(seeded);
  gappy::Study normal{study.network.stations(), study.basins};
  const plane_raster::Raster raster{51, 51, [](double, double, std::size_t) { return 0.1; }};
  normal.weighing.take_normals(
      plane_raster::normals_of(raster, raster.value, normal.network, normal.basins));
  gappy::Study uniform{study.network.stations(), study.basins};
  uniform.weighing.take_normals(std::make_shared<const UniformNormals>(
      std::vector<std::vector<double>>(study.network.stations().size(), {0.3}),
      std::vector<std::vector<double>>(study.basins.size(), {0.3})));
  for (const Gaps gaps : all_gaps) {
    const ArealRainfall plain(study.weighing, {.gaps = gaps}, 1);
    const ArealRainfall by_raster(normal.weighing, {.gaps = gaps}, 1);
    const ArealRainfall by_fields(uniform.weighing, {.gaps = gaps}, 1);
    for (const double share : {0.0, 0.05, 0.4}) {
      const auto readings = gappy::readings_of(seeded, study, share);
      const auto expected = plain.at(readings);
      const auto of_raster = by_raster.at(readings);
      const auto of_fields = by_fields.at(readings);
      for (std::size_t b = 0; b < expected.size(); ++b) {
        if (std::isnan(expected[b].rainfall)) continue;
        EXPECT_EQ(of_raster[b].rainfall, expected[b].rainfall);
        EXPECT_EQ(of_fields[b].rainfall, expected[b].rainfall);
      }
    }
  }
}

// Each month has its own values, those of a study that has that month's normals alone.
TEST(NormalsInGaps, of_months_are_each_month_s_own) {
  Seeded seeded;
  gappy::Study study = on_raster(seeded);
  give_normals(study, false, 2);
  const ArealRainfall year(study.weighing, {}, 1);
  const auto readings = gappy::readings_of(seeded, study, 0.2);
  for (const std::size_t month : {0u, 1u}) {
    gappy::Study alone{study.network.stations(), study.basins};
    const auto of_month = [month](double x, double y, std::size_t) { return hill(x, y, month); };
    alone.weighing.take_normals(
        plane_raster::normals_of({51, 51, of_month}, of_month, alone.network, alone.basins));
    const auto found = year.of_month(month)->at(readings);
    const auto expected = ArealRainfall(alone.weighing, {}, 1).at(readings);
    for (std::size_t b = 0; b < found.size(); ++b)
      EXPECT_NEAR(found[b].rainfall, expected[b].rainfall, 1e-12 * expected[b].rainfall);
  }
}

}  // namespace
}  // namespace thiessen
