#include "cli/options/blocks/view_options.h"

#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct View : Given<ViewOptions> {
  View() {
    block.declare_time(options);
    block.declare_margin(options);
    block.declare_look(options);
  }
};

TEST(ViewOptions, show_the_mean_in_a_picture_1600_wide_unless_told) {
  View view;
  view.read({});
  EXPECT_EQ(view.block.time(), "");
  EXPECT_EQ(view.block.margin, 10);
  EXPECT_EQ(view.block.units, "mm");
  EXPECT_EQ(view.block.title, "");
  EXPECT_EQ(view.block.size.width, 1600U);
  EXPECT_EQ(view.block.size.height, 0U);
}

TEST(ViewOptions, take_what_they_are_told) {
  View view;
  view.read({"--time", "2013-08-01", "--margin", "0", "--units", "", "--title", "T", "--size",
             "800x600"});
  EXPECT_EQ(view.block.time(), "2013-08-01");
  EXPECT_EQ(view.block.margin, 0);
  EXPECT_EQ(view.block.units, "");
  EXPECT_EQ(view.block.title, "T");
  EXPECT_EQ(view.block.size.height, 600U);
  EXPECT_EQ(View().refusal({"--margin", "1000.5"}),
            "--margin wants percent from 0 to 1000, not '1000.5'");
  EXPECT_EQ(View().refusal({"--time", ""}), "--time is empty");
}

// A4 at 300 dots to the inch is 297 / 25.4 x 300 = 3507.9 pixels wide.
TEST(ViewOptions, a_size_on_paper_becomes_pixels_by_its_density) {
  View view;
  view.read({"--size", "297x210mm"});
  EXPECT_EQ(view.block.dots_to_the_inch(), 300);
  EXPECT_EQ(view.block.width(), 3508);
  EXPECT_EQ(view.block.height(), 2480);
  View coarse;
  coarse.read({"--size", "254mm", "--dpi", "100"});
  EXPECT_EQ(coarse.block.width(), 1000);
  EXPECT_EQ(coarse.block.height(), 0);
  View pixels;
  pixels.read({"--dpi", "96"});
  EXPECT_EQ(pixels.block.width(), 1600) << "a density changes no pixels";
  EXPECT_EQ(pixels.block.dots_to_the_inch(), 96);
  View view_without;
  view_without.read({});
  EXPECT_EQ(view_without.block.dots_to_the_inch(), 0);
}

TEST(ViewOptions, a_size_on_paper_keeps_the_limits_of_pixels) {
  View view;
  view.read({"--size", "2000mm", "--dpi", "600"});
  EXPECT_NE(view.contradiction(true, true).find("is 47244 pixels at 600 dots to the inch"),
            std::string::npos);
}

TEST(ViewOptions, a_time_is_one_of_rainfall) {
  View view;
  view.read({"--time", "2013"});
  EXPECT_EQ(view.contradiction(true, true), "");
  EXPECT_EQ(view.contradiction(false, true), "--time needs RAINFALL");
  EXPECT_EQ(View().contradiction(false, false), "");
}

TEST(ViewOptions, several_times_stand_where_they_are_declared_and_none_comes_twice) {
  View one;
  EXPECT_EQ(one.refusal({"--time", "2013", "--time", "2014"}), "--time is given more than once");
  Given<ViewOptions> several;
  several.block.declare_times(several.options);
  several.read({"--time", "2014", "--time", "2013"});
  EXPECT_EQ(several.block.times, (std::vector<std::string>{"2014", "2013"}));
  EXPECT_EQ(several.block.time(), "2014");
  Given<ViewOptions> twice;
  twice.block.declare_times(twice.options);
  EXPECT_EQ(twice.refusal({"--time", "a", "--time", "b", "--time", "a"}), "--time names 'a' twice");
}

TEST(ViewOptions, units_are_of_readings_and_a_margin_is_of_a_study_without_basins) {
  View units;
  units.read({"--units", "mm"});
  EXPECT_EQ(units.contradiction(true, true), "");
  EXPECT_EQ(units.contradiction(false, true),
            "--units is about readings, and there is no RAINFALL");
  View margin;
  margin.read({"--margin", "10"});
  EXPECT_EQ(margin.contradiction(true, false), "");
  EXPECT_EQ(margin.contradiction(true, true),
            "--margin is of a study area without BASINS, and they are given");
}

TEST(ViewOptions, a_raster_has_no_title_and_no_size) {
  for (const char* option : {"--title", "--size"}) {
    View view;
    view.read({option, "800"});
    EXPECT_THROW(view.block.check_raster(false), UsageError) << option;
  }
  View colours;
  colours.read({"--palette", "blues"});
  EXPECT_NO_THROW(colours.block.check_raster(false));
  EXPECT_THROW(colours.block.check_raster(true), UsageError) << "a NetCDF has no colours";
  View view;
  view.read({"--units", "mm"});
  EXPECT_NO_THROW(view.block.check_raster(false));
}

TEST(ViewOptions, are_declared_one_by_one) {
  Given<ViewOptions> look;
  look.block.declare_look(look.options);
  EXPECT_EQ(look.refusal({"--margin", "5"}), "unknown option '--margin'");
  EXPECT_EQ(look.refusal({"--title", "T"}), "");
}

}  // namespace
}  // namespace thiessen::cli
