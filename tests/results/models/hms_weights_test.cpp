#include "results/models/hms_weights.h"

#include "base/complaints.h"
#include "results/written.h"

namespace thiessen {
namespace {

std::string met(const Weighing& weighing) {
  Warnings untold;
  Provenance made_by;
  made_by.software = "thiessen 9";
  const auto weights =
      weighing.weights(ReportingStations(weighing.network().stations().size(), true), 1);
  return written([&](OutputFile& file) {
    HmsWeights().write(file, {weighing, weights, made_by}, untold);
  });
}

TEST(HmsWeights, are_a_whole_meteorologic_model) {
  const TwoBasins study;
  EXPECT_EQ(met(study.weighing),
            R"(Meteorology: Thiessen weights
     Description: thiessen 9; tolerance: 0.1
     Version: 4.0
     Unit System: Metric
     Precipitation Method: Weighted Gages
     Evapotranspiration Method: No Evapotranspiration
     Snowmelt Method: None
End:

Precip Method Parameters: Weighted Gages
     Use HEC1 Weighting Scheme: No
     Use Indexing: No
     Allow Depth Override: No
End:

Gage: a"b
     Type: Recording
End:

Gage: 007
     Type: Recording
End:

Subbasin: B,1
     Gage: a"b
     Volume Weight: 0.5
     Temporal Distribution Weight: 0.5
     Gage: 007
     Volume Weight: 0.5
     Temporal Distribution Weight: 0.5
End:

Subbasin: C
     Gage: 007
     Volume Weight: 1
     Temporal Distribution Weight: 1
End:

)");
}

TEST(HmsWeights, refuse_names_that_no_line_holds) {
  const std::vector<Basin> basins{{" B", {{{{-1, -1}, {5, -1}, {5, 1}, {-1, 1}}, {}}}, {}}};
  const Network network({{"a\nb", {0, 0}}, {"far\nb", {400, 0}}}, Metric::planar);
  const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
  const auto complaints = complaints_of([&] { met(weighing); });
  ASSERT_EQ(complaints.size(), 2) << "a station that weighs nowhere is not written";
  EXPECT_TRUE(contains(complaints[0], "the basin's id ' B' cannot be a name in HEC-HMS"));
  EXPECT_TRUE(contains(complaints[1], "the station's id"));
}

}  // namespace
}  // namespace thiessen
