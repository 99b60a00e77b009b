// Linked with OpenCV: a scale bar has figures.
#include "map/sheet/footer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "map/opencv/pixel_canvas.h"
#include "map/sheet/row_of_cells.h"

namespace thiessen {
namespace {

TEST(ScaleBar, is_the_longest_round_length_that_fits) {
  const ScaleBar bar = scale_bar(0.5, 100, 180);  // 200 m to the pixel: 36 km fit
  EXPECT_EQ(bar.length.text(), "20");
  EXPECT_EQ(bar.unit, "km");
  EXPECT_NEAR(bar.pixels, 100, 1e-9);
  EXPECT_EQ(scale_bar(1, 0.3048, 100).unit, "m");
  EXPECT_EQ(scale_bar(1, 0.3048, 100).length.text(), "20");
  EXPECT_EQ(scale_bar(3, none, 100).unit, "units");
  EXPECT_EQ(scale_bar(3, none, 100).length.text(), "20");
}

TEST(ScaleBar, law_1_is_as_long_as_it_says_and_no_longer_than_the_room) {
  for (double metres = 1e-3; metres < 1e7; metres *= 1.7) {  // to the pixel
    const ScaleBar bar = scale_bar(1, metres, 200);
    const double unit = bar.unit == "km" ? 1000 : 1;
    EXPECT_NEAR(bar.pixels * metres / (bar.length.value() * unit), 1, 1e-12);
    EXPECT_LE(bar.pixels, 200 * (1 + 1e-12));
    EXPECT_GT(bar.pixels, 200 / 2.5 * (1 - 1e-12))
        << "the next round length is 2 or 2.5 times as long";
    EXPECT_EQ(bar.unit == "km", 200 * metres >= 1000);
  }
}

TEST(ScaleBar, there_is_none_where_no_length_can_be_had) {
  EXPECT_EQ(scale_bar(0, 1, 100).pixels, 0);
  EXPECT_EQ(scale_bar(HUGE_VAL, 1, 100).pixels, 0);
}

/// A footer of 800 by 68 pixels, and what is drawn into it.
struct Drawn {
  Drawn(const MapProjection& projection, bool north_is_up, const std::string& note,
        PixelBox footer = {20, 30, 800, 68}, double radius = 0) {
    page.style.em = 20;
    page.footer = footer;
    view.projection = projection;
    view.radius = radius;
    draw_footer(canvas, page, view, 1, north_is_up, note, type);
  }
  /// How many pixels of the box are dark.
  std::size_t dark(const PixelBox& box = {0, 0, 840, 120}) {
    std::size_t count = 0;
    for (int y = box.y; y < box.bottom(); ++y) {
      for (int x = box.x; x < box.right(); ++x)
        count +=
            canvas.bytes()[3 * static_cast<std::size_t>(y * canvas.width() + x)] < 200 ? 1U : 0U;
    }
    return count;
  }

  Typesetter type;
  Page page;
  StudyView view;
  PixelCanvas canvas{840, 120};
};

TEST(Footer, keeps_to_its_box) {
  Drawn drawn(MapProjection::stereographic({10, 50}), true, "labelled: 3 of 5");
  EXPECT_GT(drawn.dark({20, 30, 400, 68}), 100u) << "scale bar and arrow";
  EXPECT_GT(drawn.dark({600, 30, 220, 68}), 100u) << "notes, at the right end";
  for (const PixelBox& beside :
       {PixelBox{0, 0, 840, 30}, {0, 98, 840, 22}, {0, 0, 20, 120}, {820, 0, 20, 120}})
    EXPECT_EQ(drawn.dark(beside), 0u);
}

TEST(Footer, of_a_plane_has_an_arrow_where_north_is_up) {
  for (const double y : {0.0, 88.0, 5.5e6}) {
    const MapProjection plane = MapProjection::plane({0, y}, 1);
    const auto arrow = [&](bool north_is_up) { return Drawn(plane, north_is_up, "").dark(); };
    EXPECT_GT(arrow(true), arrow(false) + 100) << "a middle at y = " << y;
  }
}

TEST(Footer, has_no_arrow_round_a_pole_where_north_is_every_way) {
  const MapProjection polar = MapProjection::stereographic({0, 90});
  const MapProjection plane = MapProjection::plane({}, polar.metres_per_unit());
  const PixelBox left = {0, 0, 450, 120};  // the name of the projection stands on the right
  EXPECT_EQ(Drawn(polar, true, "").dark(left), Drawn(plane, false, "").dark(left));
}

// 85 degrees north, 5 degrees or 0.0873 radians from the pole.
TEST(Footer, has_no_arrow_where_the_pole_lies_on_the_map) {
  const MapProjection projection = MapProjection::stereographic({10, 85});
  const PixelBox left = {0, 0, 450, 120};
  const auto ink_of = [&](double radius) {
    return Drawn(projection, true, "", {20, 30, 800, 68}, radius).dark(left);
  };
  EXPECT_GT(ink_of(0.08), ink_of(0.09) + 100);
}

TEST(Footer, leaves_out_a_note_that_finds_no_room_and_all_where_it_has_no_height) {
  const MapProjection plane = MapProjection::plane({}, 1);
  Drawn with_long_note(plane, true, std::string(190, 'W'));
  EXPECT_EQ(with_long_note.canvas.bytes(), Drawn(plane, true, "").canvas.bytes());
  EXPECT_EQ(Drawn(plane, true, "note", {20, 30, 800, 0}).dark(), 0u);
}

}  // namespace
}  // namespace thiessen
