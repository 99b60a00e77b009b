// Linked with OpenCV: a sheet's texts are set in type.
#include "map/plot/plot_sheet.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace thiessen {
namespace {

TEST(PlotSheet, has_the_size_that_it_is_told_and_a_panel_of_its_aspect_in_the_middle) {
  for (const double aspect : {0.1, 1.0, 4.0}) {
    PlotSheet sheet(aspect, PlotSheet::Margins::for_axes, {800, 600});
    EXPECT_EQ(sheet.canvas().width(), 800);
    EXPECT_EQ(sheet.canvas().height(), 600);
    const PixelBox& panel = sheet.panel();
    EXPECT_NEAR(panel.width, panel.height * aspect, std::max(1.0, aspect)) << aspect;
    PlotSheet whole(PlotSheet::aspect_of_room(PlotSheet::Margins::for_axes, {800, 600}),
                    PlotSheet::Margins::for_axes, {800, 600});
    const PixelBox& room = whole.panel();
    EXPECT_TRUE(panel.width == room.width || panel.height == room.height);
    EXPECT_LE(std::abs(panel.x - room.x - (room.right() - panel.right())), 1);
    EXPECT_LE(std::abs(panel.y - room.y - (room.bottom() - panel.bottom())), 1);
  }
}

TEST(PlotSheet, chooses_a_height_that_fits_but_not_beyond_a_square) {
  const PlotSheet wide(4, PlotSheet::Margins::for_axes, {800});
  EXPECT_NEAR(wide.panel().width, 4 * wide.panel().height, 4);
  const PlotSheet square(1, PlotSheet::Margins::for_axes, {800});
  PlotSheet tall(0.1, PlotSheet::Margins::for_axes, {800});
  EXPECT_EQ(tall.panel().height, square.panel().height);
  EXPECT_NEAR(tall.panel().width, 0.1 * tall.panel().height, 1);
}

TEST(PlotSheet, too_small_for_text_is_the_panel_alone) {
  PlotSheet sheet(1, PlotSheet::Margins::for_axes, {64, 64});
  EXPECT_EQ(sheet.panel().width, 64);
  EXPECT_EQ(sheet.panel().height, 64);
  sheet.write_legend(3, 3);
  sheet.write_note("a note");
  sheet.write_sentence("a sentence");
  EXPECT_EQ(sheet.canvas().darkness(sheet.panel()), 0u);
}

}  // namespace
}  // namespace thiessen
