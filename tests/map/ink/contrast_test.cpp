#include "map/ink/contrast.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

constexpr Colour black{0, 0, 0};
constexpr Colour white{255, 255, 255};

TEST(Contrast, is_of_black_and_white_21_and_of_one_colour_1) {
  EXPECT_NEAR(contrast(black, white), 21, 1e-9);
  EXPECT_NEAR(contrast(white, black), 21, 1e-9);
  EXPECT_NEAR(contrast({71, 44, 122}, {71, 44, 122}), 1, 1e-12);
}

// The grey of 188 has half of white's light: ((188/255 + 0.055) / 1.055)^2.4 = 0.5029.
TEST(Contrast, goes_by_the_light_that_colours_send) {
  EXPECT_NEAR(contrast({188, 188, 188}, white), 1.05 / 0.5529, 1e-3);
  EXPECT_NEAR(contrast({0, 255, 0}, black), (0.7152 + 0.05) / 0.05, 1e-9);
}

TEST(Blended, is_the_ground_under_no_ink_and_the_ink_where_it_is_opaque) {
  EXPECT_EQ(blended({10, 200, 30}, white, 0), (Colour{10, 200, 30}));
  EXPECT_EQ(blended({10, 200, 30}, white, 255), white);
  EXPECT_EQ(blended({0, 100, 255}, {255, 50, 0}, 51), (Colour{51, 90, 204}));
}

}  // namespace
}  // namespace thiessen
