// The standard error of a mean beside the truth of simulated fields.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/errors/lasting_series.h"
#include "rainfall/errors/mean_error.h"

namespace thiessen {
namespace {

constexpr Yardstick plane{Metric::planar, 1, 0.1};

// Whether errors cancel from step to step or last, and with gaps, the mean's bars hold the truth in
// 93 to 97 % of cases, of which 2,000 tell to half a percent.
TEST(MeanErrorCoverage, has_bars_that_hold_the_true_mean) {
  Seeded seeded;
  const std::vector<Basin> basins = quarters();
  for (const SeriesSetting& setting : {SeriesSetting{"independent steps", 0, 0, 30},
                                       SeriesSetting{"half of the variance lasts", 0.5, 0, 30},
                                       SeriesSetting{"independent, a fifth silent", 0, 0.2, 30},
                                       SeriesSetting{"half lasts, a fifth silent", 0.5, 0.2, 30}}) {
    double within = 0;
    double bars = 0;
    for (std::uint64_t round = Seeded::rounds(500); round > 0; --round) {
      const LastingSeries series(seeded, setting);
      const Network network(series.stations(), Metric::planar);
      const Weighing weighing(network, basins, plane);
      const ArealRainfall rainfall(weighing, {}, 1);
      MeanError error(rainfall, weighing);
      std::vector<double> sums(4, 0);
      for (const auto& readings : series.steps()) {
        error.add(readings);
        const auto values = rainfall.at(readings);
        for (std::size_t b = 0; b < 4; ++b) sums[b] += values[b].rainfall;
      }
      const std::vector<double> errors = error.result(1);
      for (std::size_t b = 0; b < 4; ++b) {
        const double mean = sums[b] / static_cast<double>(setting.steps);
        within += std::abs(mean - series.truth(b)) <= 1.96 * errors[b];
        ++bars;
      }
    }
    std::printf("%-32s %5.2f %%\n", setting.name, 100 * within / bars);
    EXPECT_GE(within / bars, 0.925) << setting.name;
    EXPECT_LE(within / bars, 0.975) << setting.name;
  }
}

}  // namespace
}  // namespace thiessen
