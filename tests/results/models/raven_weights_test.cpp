#include "results/models/raven_weights.h"

#include "base/complaints.h"
#include "results/written.h"

namespace thiessen {
namespace {

std::string table(const Weighing& weighing, Warnings& told) {
  Provenance made_by;
  made_by.software = "thiessen 9";
  const auto weights =
      weighing.weights(ReportingStations(weighing.network().stations().size(), true), 1);
  return written([&](OutputFile& file) {
    RavenWeights().write(file, {weighing, weights, made_by}, told);
  });
}

TEST(RavenWeights, have_a_row_a_basin_with_every_gauge) {
  const TwoBasins study;
  Warnings told;
  EXPECT_EQ(table(study.weighing, told),
            "# thiessen 9; tolerance: 0.1\n# gauge 1: a\"b\n# gauge 2: 007\n# HRU 1: B,1\n"
            "# HRU 2: C\n:GaugeWeightTable\n  2 2\n  0.5 0.5\n  0 1\n:EndGaugeWeightTable\n");
  EXPECT_TRUE(told.messages().empty());
}

TEST(RavenWeights, of_more_gauges_than_a_line_holds_are_warned_of) {
  std::vector<Station> stations;
  for (int i = 0; i < 501; ++i) stations.push_back({std::to_string(i), {1.0 * i, 0}});
  const std::vector<Basin> basins{{"B", {{{{-1, -1}, {5, -1}, {5, 1}, {-1, 1}}, {}}}, {}}};
  const Network network(std::move(stations), Metric::planar);
  Warnings told;
  table(Weighing(network, basins, {Metric::planar, 1, 0.1}), told);
  EXPECT_TRUE(contains(sentences_of(told).at(0), "there are 501 gauges"));
}

}  // namespace
}  // namespace thiessen
