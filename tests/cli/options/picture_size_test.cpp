#include "cli/options/picture_size.h"

#include <gtest/gtest.h>

#include "cli/options/usage_error.h"

namespace thiessen::cli {
namespace {

TEST(PictureSize, in_pixels_is_what_it_says) {
  const PictureSize size{{800, 600, false}, 96};
  EXPECT_EQ(size.width(), 800);
  EXPECT_EQ(size.height(), 600);
  EXPECT_EQ(size.dots_to_the_inch(), 96);
  EXPECT_EQ(PictureSize{}.dots_to_the_inch(), 0);
}

// An inch is 25.4 mm.
TEST(PictureSize, in_millimetres_counts_by_the_density) {
  EXPECT_EQ((PictureSize{{254, 127, true}, 100}.width()), 1000);
  EXPECT_EQ((PictureSize{{254, 0, true}, 0}.width()), 3000);
  EXPECT_EQ((PictureSize{{254, 0, true}, 0}.height()), 0);
}

TEST(PictureSize, in_millimetres_has_the_limits_of_pixels) {
  EXPECT_NO_THROW((PictureSize{{254, 127, true}, 100}.check_size()));
  EXPECT_THROW((PictureSize{{2, 2, true}, 100}.check_size()), UsageError);
  EXPECT_THROW((PictureSize{{5000, 5000, true}, 1200}.check_size()), UsageError);
}

}  // namespace
}  // namespace thiessen::cli
