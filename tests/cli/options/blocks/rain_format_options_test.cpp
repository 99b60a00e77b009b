#include "cli/options/blocks/rain_format_options.h"

#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct Format : Given<RainFormatOptions> {
  Format() { block.declare(options); }
};

TEST(RainFormatOptions, are_a_column_a_basin_and_three_decimals_unless_told) {
  Format format;
  format.read({});
  EXPECT_FALSE(format.block.format().rows_for_basins);
  EXPECT_EQ(format.block.format().decimals, 3);
}

TEST(RainFormatOptions, take_rows_and_decimals_as_told) {
  Format format;
  format.read({"--long", "--decimals", "0"});
  EXPECT_TRUE(format.block.format().rows_for_basins);
  EXPECT_EQ(format.block.format().decimals, 0);
  EXPECT_EQ(Format().refusal({"--decimals", "15"}), "");
  EXPECT_EQ(Format().refusal({"--decimals", "16"}),
            "--decimals wants a whole number from 0 to 15, not '16'");
}

}  // namespace
}  // namespace thiessen::cli
