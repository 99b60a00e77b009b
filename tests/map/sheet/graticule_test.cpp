// Linked with OpenCV: coordinates are set in type.
#include "map/sheet/graticule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "map/opencv/pixel_canvas.h"

namespace thiessen {
namespace {

std::vector<std::string> texts(double low, double high, int most, FrameAxis axis) {
  std::vector<std::string> result;
  const auto value = [&](double at) { return low + (high - low) * at / 1000; };
  for (const FrameTick& tick : frame_ticks(value, 1000, most, axis)) result.push_back(tick.text);
  return result;
}

using Texts = std::vector<std::string>;

TEST(FrameTicks, are_round_and_have_equal_decimals) {
  EXPECT_EQ(texts(0.9, 3.1, 5, FrameAxis::plane), (Texts{"1.0", "1.5", "2.0", "2.5", "3.0"}));
  EXPECT_EQ(texts(499'000, 502'500, 4, FrameAxis::plane),
            (Texts{"499000", "500000", "501000", "502000"}));
  EXPECT_EQ(texts(3.1, 0.9, 5, FrameAxis::plane), (Texts{"3.0", "2.5", "2.0", "1.5", "1.0"}));
}

TEST(FrameTicks, of_degrees_name_the_side_of_the_earth) {
  EXPECT_EQ(texts(-1.1, 1.1, 2, FrameAxis::latitude), (Texts{"0°"}));
  EXPECT_EQ(texts(-1.1, 1.1, 3, FrameAxis::latitude), (Texts{"1° S", "0°", "1° N"}));
  EXPECT_EQ(texts(-105.65, -104.9, 4, FrameAxis::longitude),
            (Texts{"105.6° W", "105.4° W", "105.2° W", "105.0° W"}));
  EXPECT_EQ(texts(165, 205, 4, FrameAxis::longitude),
            (Texts{"170° E", "180°", "170° W", "160° W"}));
}

TEST(FrameTicks, of_the_whole_earth_part_its_turn) {
  EXPECT_EQ(texts(-190, 190, 13, FrameAxis::longitude).size(), 13u) << "thirty degrees apart";
  EXPECT_EQ(texts(-85, 85, 4, FrameAxis::latitude), (Texts{"60° S", "0°", "60° N"}));
}

TEST(FrameTicks, lie_where_the_coordinate_has_their_value) {
  const auto square = [](double at) { return at * at / 1e6; };
  for (const FrameTick& tick : frame_ticks(square, 1000, 10, FrameAxis::plane))
    EXPECT_NEAR(square(tick.at), std::stod(tick.text), 1e-4);
}

TEST(FrameTicks, there_are_none_where_a_coordinate_does_not_change_or_is_none) {
  EXPECT_TRUE(texts(5, 5, 5, FrameAxis::plane).empty());
  EXPECT_TRUE(texts(0, HUGE_VAL, 5, FrameAxis::plane).empty());
  EXPECT_TRUE(texts(0, 1, 0, FrameAxis::plane).empty());
  EXPECT_TRUE(texts(1e18, 1e18 + 4096, 5, FrameAxis::plane).empty()) << "beyond what digits tell";
}

TEST(Graticule, stands_to_the_left_of_the_panel_and_below_it) {
  Page page;
  page.style.em = 20;
  page.panel = {70, 20, 600, 400};
  StudyView view;
  const PanelTransform transform({0, 0, 6, 4}, page.panel);
  Typesetter type;
  PixelCanvas canvas(700, 460);
  draw_graticule(canvas, page, view, transform, FrameEdges(), type);
  EXPECT_EQ(canvas.darkness({70, 0, 630, 420}), 0u);
  EXPECT_GT(canvas.darkness({0, 20, 70, 400}), 5000u);
  EXPECT_GT(canvas.darkness({50, 420, 650, 40}), 5000u);
}

TEST(Graticule, has_no_mark_where_there_is_no_room_for_its_number) {
  Page page;
  page.style.em = 20;
  page.panel = {12, 20, 600, 400};
  StudyView view;
  const PanelTransform transform({0, 0, 6, 4}, page.panel);
  Typesetter type;
  PixelCanvas canvas(700, 460);
  draw_graticule(canvas, page, view, transform, FrameEdges(), type);
  EXPECT_EQ(canvas.darkness({0, 20, 12, 400}), 0u);
  EXPECT_GT(canvas.darkness({12, 420, 650, 40}), 5000u) << "below there is some";
}

}  // namespace
}  // namespace thiessen
