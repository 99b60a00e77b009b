#include "study/lost_digits.h"

#include <gtest/gtest.h>

#include "base/complaints.h"
#include "study/thiessen.h"

namespace thiessen {
namespace {

/// A lattice of 4 by 4 gauges with a spacing of 1 whose middle is a corner away from `origin`, in a
/// basin of 4 by 4: each has a sixteenth.
ThiessenInput lattice_at(double origin) {
  ThiessenInput input;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y)
      input.stations.push_back({std::to_string(4 * x + y), {origin + x, origin + y}});
  }
  const double low = origin - 0.5;
  const double high = origin + 3.5;
  input.basins = {{"B", {{{{low, low}, {high, low}, {high, high}, {low, high}}, {}}}, {}}};
  return input;
}

std::string fault_at(double origin) {
  return complaint_of([&] { const Thiessen unused(lattice_at(origin)); });
}

TEST(LostDigits, are_refused_where_cells_would_be_lost) {
  EXPECT_EQ(fault_at(1e15),
            "so far from the plane's origin positions are told apart to 1.8, and basin 'B' is 4.0 "
            "across: weights would be off by up to 0.44 | take the same numbers off all "
            "coordinates of gauges and basins, so that they are near 0");
  EXPECT_NE(fault_at(1e12).find("weights would be off by up to 0.00044"), std::string::npos);
}

TEST(LostDigits, are_told_where_they_still_matter) {
  const Thiessen study(lattice_at(1e9));
  ASSERT_EQ(study.warnings().size(), 1U);
  EXPECT_NE(study.warnings()[0].sentence().find("weights may be off by up to 0.00000044"),
            std::string::npos)
      << study.warnings()[0].sentence();
  for (const StationWeight& gauge : study.weights()[0].stations)
    EXPECT_NEAR(gauge.weight, 1.0 / 16, 4.4e-7);
}

TEST(LostDigits, are_none_in_the_coordinates_that_people_use) {
  for (const double origin : {0.0, 5e5, 4e6}) {
    const Thiessen study(lattice_at(origin));
    EXPECT_TRUE(study.warnings().empty());
    ASSERT_EQ(study.weights()[0].stations.size(), 16U);
    for (const StationWeight& gauge : study.weights()[0].stations)
      EXPECT_EQ(gauge.weight, 1.0 / 16);
  }
}

}  // namespace
}  // namespace thiessen
