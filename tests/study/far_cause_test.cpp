#include "study/far_cause.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen {
namespace {

/// Of a place that a file has wrongly, as a cause says: where the cause puts it right.
struct Mended {
  std::string cause;
  std::vector<Point> gauges;  ///< none: they stay where they are
  std::vector<Point> basins;
};

void expect_causes(bool on_earth, const std::vector<Point>& wrong,
                   const std::vector<Mended>& wanted) {
  const std::vector<FarCause> causes = far_causes_of_coordinates(on_earth);
  ASSERT_EQ(causes.size(), wanted.size());
  for (std::size_t i = 0; i < causes.size(); ++i) {
    SCOPED_TRACE(wanted[i].cause);
    EXPECT_EQ(causes[i].text.plain(), wanted[i].cause);
    const auto by = [&](const FarCause::Correction& correction) {
      return correction ? correction(wrong) : std::vector<Point>();
    };
    EXPECT_EQ(by(causes[i].gauges), wanted[i].gauges);
    EXPECT_EQ(by(causes[i].basins), wanted[i].basins);
  }
}

TEST(FarCause, on_the_earth_it_is_the_order_or_a_sign_of_the_gauges) {
  expect_causes(true, {{47, 11}, {-48, 12}},
                {{"latitude and longitude swapped in one of the files", {{11, 47}, {12, -48}}, {}},
                 {"the other sign of longitude (west is negative)", {{-47, 11}, {48, 12}}, {}},
                 {"the other sign of latitude (south is negative)", {{47, -11}, {-48, -12}}, {}}});
}

// Of basins in kilometres it is the gauges that are corrected, to kilometres: it only matters
// whether both then meet, and no basin need be touched.
TEST(FarCause, in_a_plane_it_may_be_the_unit_too) {
  expect_causes(false, {{500, -5200}},
                {{"x and y swapped in one of the files", {{-5200, 500}}, {}},
                 {"the gauges' coordinates in kilometres, not metres", {{500000, -5200000}}, {}},
                 {"the basins' coordinates in kilometres, not metres", {{0.5, -5.2}}, {}},
                 {"the other sign of x", {{-500, -5200}}, {}},
                 {"the other sign of y", {{500, 5200}}, {}}});
}

}  // namespace
}  // namespace thiessen
