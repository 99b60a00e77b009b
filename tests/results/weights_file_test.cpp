#include "results/weights_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "results/written.h"

namespace thiessen {
namespace {

TEST(WeightsFile, has_a_row_a_weight_with_ids_as_written_and_areas_in_km2) {
  const TwoBasins study;
  const auto weights = study.weighing.weights({true, true}, 1);
  EXPECT_EQ(written([&](OutputFile& file) {
              write_weights(file, study.weighing, {weights}, AreaUnit{1e-6});
            }),
            "basin,station,area_km2,weight\n"
            "\"B,1\",\"a\"\"b\",0.000006,0.5\n"
            "\"B,1\",007,0.000006,0.5\n"
            "C,007,0.000004,1\n");
}

TEST(WeightsFile, is_the_same_by_any_number_of_threads) {
  const TwoBasins study;
  std::vector<BasinWeights> weights(2);
  for (int i = 0; i < 30'000; ++i)
    weights[i % 3 == 0 ? 0 : 1].stations.push_back(
        {StationIndex{i % 2 == 0 ? 0U : 1U}, i / 8.0, 0.5});
  const auto by_threads = [&](unsigned threads) {
    return written([&](OutputFile& file) {
      write_weights(file, study.weighing, {weights}, AreaUnit{1}, threads);
    });
  };
  const std::string alone = by_threads(1);
  EXPECT_EQ(std::count(alone.begin(), alone.end(), '\n'), 30'001);
  EXPECT_TRUE(alone.ends_with("\nC,007,3749.875,0.5\n"));
  EXPECT_EQ(by_threads(3), alone);
}

TEST(WeightsFile, rows_have_the_names_and_the_unit_of_the_table) {
  const TwoBasins study;
  const auto weights = study.weighing.weights({true, true}, 1);
  const std::vector<WeightRow> rows = weight_rows(study.weighing, weights, AreaUnit{0.5});
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].basin, "B,1");
  EXPECT_EQ(rows[0].station, "a\"b");
  EXPECT_DOUBLE_EQ(rows[0].area, 3);
  EXPECT_DOUBLE_EQ(rows[0].weight, 0.5);
  EXPECT_EQ(rows[2].basin, "C");
  EXPECT_EQ(rows[2].station, "007");
}

TEST(WeightsFile, of_a_change_has_the_stations_that_weigh_before_or_after) {
  const TwoBasins study;
  const auto before = study.weighing.weights({true, true}, 1);
  const auto after = study.weighing.weights({true, false}, 1);
  EXPECT_EQ(written([&](OutputFile& file) {
              write_changed_weights(file, study.weighing, {before}, {after}, AreaUnit{1});
            }),
            "basin,station,area,weight,area_after,weight_after\n"
            "\"B,1\",\"a\"\"b\",6,0.5,12,1\n"
            "\"B,1\",007,6,0.5,0,0\n"
            "C,\"a\"\"b\",0,0,4,1\n"
            "C,007,4,1,0,0\n");
}

}  // namespace
}  // namespace thiessen
