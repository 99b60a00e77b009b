#include "results/weights_log.h"

#include <gtest/gtest.h>

#include "results/written.h"

namespace thiessen {
namespace {

TEST(WeightsLog, has_a_block_a_pattern_and_no_row_for_a_basin_without_a_value) {
  const TwoBasins study;
  EXPECT_EQ(written([&](OutputFile& file) {
              WeightsLog log(file, study.weighing);
              log.add(1, "2013-08-01", study.weighing.weights({true, true}, 1));
              log.add(2, "a,b", {{12, {{StationIndex{0}, 12, 1}}}, {4, {}}});
            }),
            "pattern,first_time,basin,station,weight\n"
            "1,2013-08-01,\"B,1\",\"a\"\"b\",0.5\n"
            "1,2013-08-01,\"B,1\",007,0.5\n"
            "1,2013-08-01,C,007,1\n"
            "2,\"a,b\",\"B,1\",\"a\"\"b\",1\n");
}

}  // namespace
}  // namespace thiessen
