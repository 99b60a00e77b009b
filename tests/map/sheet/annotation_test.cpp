// Linked with OpenCV: names and labels are set in type.
#include "map/sheet/annotation.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "map/ink/ink.h"
#include "map/opencv/pixel_canvas.h"

namespace thiessen {
namespace {

/// A panel of 400 by 300 pixels at (10, 20) of a page, and gauges in it.
struct Panel {
  explicit Panel(std::vector<Point> gauges, const std::string& label = "") {
    page.style.em = 20;
    page.panel = {10, 20, 400, 300};
    for (const Point gauge : gauges) picture.gauges.push_back({gauge, label});
    view.gauges = std::move(gauges);
  }
  Colour at(int x, int y) {
    const auto first = 3 * static_cast<std::size_t>(y * canvas.width() + x);
    return {canvas.bytes()[first + 2], canvas.bytes()[first + 1], canvas.bytes()[first]};
  }
  /// How many pixels of the box are dark.
  std::size_t ink(const PixelBox& box) {
    std::size_t dark = 0;
    for (int y = box.y; y < box.bottom(); ++y) {
      for (int x = box.x; x < box.right(); ++x) dark += at(x, y).green < 128 ? 1U : 0U;
    }
    return dark;
  }

  Typesetter type;
  Page page;
  Picture picture;
  StudyView view;
  PixelCanvas canvas{420, 340};
};

TEST(Annotation, draws_gauges_where_they_are_and_whole_or_not_at_all) {
  Panel panel({{100, 50}, {399, 150}, {-3, 20}, {200.5, 299.5}});
  Annotation annotation(panel.canvas, panel.page, panel.picture, panel.view, panel.type);
  annotation.draw_gauges();
  EXPECT_EQ(panel.at(110, 70), ink::gauge);
  EXPECT_EQ(panel.at(408, 170), ink::white);
  EXPECT_EQ(panel.at(210, 318), ink::white);
  EXPECT_EQ(note_of(annotation.count()), "gauges in sight: 1 of 4");
}

TEST(Annotation, a_silent_gauge_hides_none_that_reports) {
  Panel panel({{100, 50}, {100, 50}});
  panel.picture.gauges[1].reports = false;
  Annotation(panel.canvas, panel.page, panel.picture, panel.view, panel.type).draw_gauges();
  EXPECT_EQ(panel.at(110, 70), ink::gauge);
}

TEST(Annotation, labels_gauges_of_the_largest_cells_first_as_far_as_there_is_room) {
  // The labels of all but the outer two would stand beside the dots of others.
  std::vector<Point> dots;
  for (int i = 0; i < 10; ++i) dots.push_back({120.0 + 16 * i, 150});
  Panel panel(dots, "a long label");
  Annotation annotation(panel.canvas, panel.page, panel.picture, panel.view, panel.type);
  annotation.draw_gauges();
  EXPECT_EQ(note_of(annotation.count()), "");
  annotation.draw_labels(std::vector<std::size_t>(10, 5));
  EXPECT_EQ(note_of(annotation.count()), "labelled: 2 of 10");
  EXPECT_GT(panel.ink({10, 20, 400, 300}), 200U);
}

TEST(Annotation, all_labels_that_find_room_need_no_note) {
  Panel panel({{100, 100}, {300, 200}}, "A-1");
  Annotation annotation(panel.canvas, panel.page, panel.picture, panel.view, panel.type);
  annotation.draw_gauges();
  annotation.draw_labels({9, 3});
  EXPECT_EQ(note_of(annotation.count()), "");
  EXPECT_GT(panel.ink({115, 100, 60, 40}), 20U) << "to the right of the dot at (110, 120)";
}

TEST(Annotation, the_larger_of_two_cells_has_its_label_where_both_want_the_same_place) {
  // The ink to the right of two gauges at one place: the first place for a label of either.
  const auto ink_of = [](const std::vector<std::string>& labels,
                         const std::vector<std::size_t>& pixels) {
    Panel panel({{200, 150}, {200, 150}});
    for (std::size_t i = 0; i < 2; ++i) panel.picture.gauges[i].label = labels[i];
    Annotation annotation(panel.canvas, panel.page, panel.picture, panel.view, panel.type);
    annotation.draw_gauges();
    annotation.draw_labels(pixels);
    return panel.ink({217, 150, 100, 40});
  };
  const std::size_t first = ink_of({"IIIIIIII", ""}, {9, 9});
  const std::size_t second = ink_of({"", "W"}, {9, 9});
  ASSERT_NE(first, second);
  EXPECT_EQ(ink_of({"IIIIIIII", "W"}, {9, 1}), first);
  EXPECT_EQ(ink_of({"IIIIIIII", "W"}, {1, 9}), second);
  EXPECT_EQ(ink_of({"IIIIIIII", "W"}, {5, 5}), first) << "of equal ones the first";
}

TEST(Annotation, writes_levels_on_their_lines_and_clear_of_dots) {
  Panel panel({{200, 150}});
  panel.picture.isohyets = {{"25", {}}};
  panel.view.isohyets = {{{{20, 150}, {380, 150}}}};
  Annotation annotation(panel.canvas, panel.page, panel.picture, panel.view, panel.type);
  annotation.draw_gauges();
  const std::size_t dot = panel.ink({10, 20, 400, 300});
  annotation.draw_levels();
  EXPECT_GT(panel.ink({10, 155, 400, 30}), dot + 40U);
  EXPECT_EQ(panel.ink({203, 155, 14, 30}), dot) << "the dot at (210, 170) is as it was";
  EXPECT_EQ(panel.ink({10, 155, 400, 30}), panel.ink({10, 20, 400, 300})) << "nowhere else";
}

TEST(Annotation, names_a_basin_inside_it_and_not_where_it_finds_no_room) {
  Panel panel(std::vector<Point>{});
  panel.picture.basins = {{"Basin", {}}, {"Long name of a basin", {}}, {"", {}}};
  LabelImage basins(400, 300);
  const Ring wide = {{50, 50}, {250, 50}, {250, 150}, {50, 150}};
  const Ring narrow = {{300, 50}, {320, 50}, {320, 290}, {300, 290}};
  basins.fill({&wide, 1}, 0);
  basins.fill({&narrow, 1}, 1);
  Annotation(panel.canvas, panel.page, panel.picture, panel.view, panel.type)
      .draw_basin_names(basins);
  EXPECT_GT(panel.ink({60, 70, 200, 100}), 50U);
  EXPECT_EQ(panel.ink({60, 70, 200, 100}), panel.ink({0, 0, 420, 340})) << "nowhere else";
}

}  // namespace
}  // namespace thiessen
