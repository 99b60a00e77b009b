#include "cli/outputs/shown_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cli/outputs/given_inputs.h"

namespace thiessen::cli {
namespace {

using Values = std::vector<double>;

/// Two gauges with ground in the two basins, and one too far away to have any.
GivenFiles files() {
  GivenFiles files;
  files.stations = "id,x,y\nfar,100,2\nB,8,2\nA,0,2\n";
  files.basins =
      "id,WKT\nP,\"POLYGON ((0 0,10 0,10 4,0 4,0 0))\"\nQ,\"POLYGON ((1 0,9 0,9 9,1 9,1 0))\"\n";
  return files;
}

TEST(ShownValues, are_the_readings_of_the_gauges_that_have_ground_once_each) {
  const GivenInputs given(files());
  EXPECT_EQ(shown_values(given.inputs, {{50, 2, 1}, ""}, 1), (Values{2, 1}));
  EXPECT_EQ(shown_values(given.inputs, {{50, 2, 2}, ""}, 2), (Values{2, 2})) << "of two gauges";
}

TEST(ShownValues, are_those_of_the_gauges_that_have_the_ground_of_silent_ones) {
  const GivenInputs given(files());
  const double silent = std::nan("");
  EXPECT_EQ(shown_values(given.inputs, {{50, 2, silent}, ""}, 1), Values{2});
  EXPECT_EQ(shown_values(given.inputs, {{50, silent, silent}, ""}, 1), Values{50});
  EXPECT_EQ(shown_values(given.inputs, {{silent, silent, silent}, ""}, 1), Values{});
}

}  // namespace
}  // namespace thiessen::cli
