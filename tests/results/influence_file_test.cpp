#include "results/influence_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "results/written.h"

namespace thiessen {
namespace {

TEST(InfluenceFile, leaves_changes_empty_where_no_step_has_a_value_without_the_gauge) {
  const TwoBasins study;
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(written([&](OutputFile& file) {
              write_influence(
                  file, study.weighing,
                  {{{StationIndex{0}, 0.5, 1.25, -0.1}}, {{StationIndex{1}, 1, none, none}}});
            }),
            "basin,station,weight,rms_change,mean_change\n"
            "\"B,1\",\"a\"\"b\",0.5,1.25,-0.1\n"
            "C,007,1,,\n");
}

}  // namespace
}  // namespace thiessen
