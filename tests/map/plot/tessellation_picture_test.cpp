#include "map/plot/tessellation_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <csignal>
#include <limits>
#include <random>
#include <string>

#include "base/error.h"
#include "base/interrupt.h"
#include "gdal/output/image_file.h"
#include "map/plot/plane_plot.h"
#include "map/plot/plot_sheet.h"
#include "map/plot/space_view.h"

namespace thiessen {
namespace {

enum class Ink { none, red, blue };

Ink ink_at(PixelCanvas& canvas, int x, int y) {
  const auto offset = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.width()) +
                           static_cast<std::size_t>(x));
  const int blue = canvas.bytes()[offset];
  const int red = canvas.bytes()[offset + 2];
  constexpr int plainly = 60;
  return red > blue + plainly ? Ink::red : blue > red + plainly ? Ink::blue : Ink::none;
}

std::uint64_t own_number(PointId p) {
  return index(p);
}

template <int Dimension>
Tessellation<Dimension> tessellation_of(const std::vector<PositionIn<Dimension>>& points) {
  Tessellation<Dimension> tessellation;
  tessellation.add_all(points);
  return tessellation;
}

PixelBox panel_of(const Tessellation<2>& tessellation) {
  const PlanePlot plot{CoordinateRange<2>(tessellation)};
  return PlotSheet(plot.aspect(), PlotSheet::Margins::for_axes).panel();
}

std::vector<Point> random_points(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Point> points(count);
  for (Point& p : points) p = {3 * coordinate(random), 2 * coordinate(random)};
  return points;
}

std::vector<SpacePoint> random_space_points(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
  return points;
}

TEST(PlanePicture, of_two_points_has_a_solid_red_line_across_a_dashed_blue_one) {
  const auto tessellation = tessellation_of<2>({{1, 7}, {5, 7}});
  const PixelBox panel = panel_of(tessellation);
  PixelCanvas canvas = plot_plane(tessellation, own_number);
  const int middle_x = panel.x + panel.width / 2;
  const int middle_y = panel.y + panel.height / 2;
  int red_rows = 0;
  for (int y = panel.y; y < panel.bottom(); ++y) {
    bool is_red = false;
    for (int x = panel.x; x < panel.right(); ++x) {
      const Ink ink = ink_at(canvas, x, y);
      if (ink == Ink::red) {
        EXPECT_LE(std::abs(x - middle_x), 2);
      }
      if (ink == Ink::blue) {
        EXPECT_LE(std::abs(y - middle_y), 2);
      }
      is_red = is_red || ink == Ink::red;
    }
    red_rows += is_red;
  }
  EXPECT_GE(red_rows, panel.height - 2 * PlotSheet(1, PlotSheet::Margins::plain).style().hairline);

  int changes = 0;
  int blue_columns = 0;
  bool was_blue = false;
  for (int x = panel.x; x < panel.right(); ++x) {
    bool is_blue = false;
    for (int y = middle_y - 2; y <= middle_y + 2; ++y) {
      is_blue = is_blue || ink_at(canvas, x, y) == Ink::blue;
    }
    changes += is_blue != was_blue;
    blue_columns += is_blue;
    was_blue = is_blue;
  }
  EXPECT_GT(changes, 40);
  EXPECT_GT(blue_columns, panel.width / 4);
  EXPECT_LT(blue_columns, panel.width * 3 / 4);
}

TEST(PlanePicture, keeps_its_lines_in_the_panel) {
  std::vector<Point> points = random_points(300, 2);
  points.push_back({1.5, -0.001});  // its neighbours' vertices lie far off
  const auto tessellation = tessellation_of<2>(points);
  const PixelBox panel = panel_of(tessellation);
  PixelCanvas canvas = plot_plane(tessellation, own_number);
  int inside = 0;
  for (int y = panel.y; y < canvas.height(); ++y) {
    for (int x = 0; x < canvas.width(); ++x) {
      if (ink_at(canvas, x, y) == Ink::none) continue;
      EXPECT_TRUE(x >= panel.x && x < panel.right() && y < panel.bottom()) << x << " " << y;
      ++inside;
    }
  }
  EXPECT_GT(inside, 10'000);
}

std::uint64_t number_at(double x, double y) {
  return static_cast<std::uint64_t>(1 + 10 * x) * 100 + static_cast<std::uint64_t>(1 + 10 * y);
}

TEST(PlanePicture, does_not_depend_on_the_order_of_the_points_or_the_locale) {
  std::vector<Point> points = random_points(30, 4);
  for (int i = 0; i < 9; ++i) points.push_back({i % 3 * 1.0, i / 3 * 1.0});
  const auto picture = [](const Tessellation<2>& t) {
    return plane_picture(
        t, [&t](PointId p) { return number_at(t.position(p).x, t.position(p).y); }, image_file);
  };
  const auto first = picture(tessellation_of<2>(points));
  EXPECT_EQ(picture(tessellation_of<2>(points)), first);
  std::shuffle(points.begin(), points.end(), std::mt19937_64(3));
  Tessellation<2> other;
  other.add({77, 77});
  for (const Point p : points) other.add(p);
  other.remove(*other.find({77, 77}));
  EXPECT_EQ(picture(other), first);
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "tr_TR.UTF-8", "C.UTF-8"}) {
    if (std::setlocale(LC_ALL, locale) != nullptr) {
      EXPECT_EQ(picture(other), first) << locale;
    }
  }
  std::setlocale(LC_ALL, before.c_str());
}

/// The panel of a window's picture, and what is drawn in it.
struct WindowPicture {
  PixelBox panel;
  PixelCanvas canvas;

  WindowPicture(const Tessellation<2>& tessellation, const PlaneWindow& window,
                const PlotSize& size = {})
      : panel(PlotSheet(PlanePlot::of_window(window).aspect(), PlotSheet::Margins::for_axes, size)
                  .panel()),
        canvas(plot_plane(
            tessellation,
            [&](PointId p) {
              return number_at(tessellation.position(p).x, tessellation.position(p).y);
            },
            window, size)) {}

  std::vector<std::uint8_t> pixels() {
    std::vector<std::uint8_t> inside;
    for (int y = panel.y; y < panel.bottom(); ++y) {
      const auto from = 3 * (static_cast<std::ptrdiff_t>(y) * canvas.width() + panel.x);
      const auto row = canvas.bytes().begin() + from;
      inside.insert(inside.end(), row, row + std::ptrdiff_t{3} * panel.width);
    }
    return inside;
  }
};

// The points are far off, on either side: there is one red line across the middle, from border to
// border, and the dashed one between the points.
TEST(PlaneWindowPicture, without_points_shows_the_edges_that_cross_it) {
  const auto tessellation = tessellation_of<2>({{-1000, 5}, {1020, 5}, {10, 1e7}});
  WindowPicture picture(tessellation, {{0, 0}, {20, 10}});
  const PixelBox& panel = picture.panel;
  const int border = PlotSheet(1, PlotSheet::Margins::plain).style().hairline;
  int blue = 0;
  for (int y = panel.y + border; y < panel.bottom() - border; ++y) {
    int red = 0;
    for (int x = panel.x + border; x < panel.right() - border; ++x) {
      const Ink ink = ink_at(picture.canvas, x, y);
      blue += ink == Ink::blue ? 1 : 0;
      if (ink != Ink::red) continue;
      ++red;
      EXPECT_LE(std::abs(x - (panel.x + panel.width / 2)), 3);
    }
    EXPECT_GT(red, 0) << y;
  }
  EXPECT_GT(blue, 0) << "the edge between the two points runs along y = 5";
}

// The judge is the picture of the points near by alone: what is farther away than twice the window
// neither comes into it nor changes what does.
TEST(PlaneWindowPicture, is_the_part_of_the_whole_that_lies_in_it) {
  std::vector<Point> points = random_points(3000, 7);
  const PlaneWindow window{{1.3, 0.9}, {1.7, 1.1}};
  const auto whole = tessellation_of<2>(points);
  std::erase_if(points,
                [](Point p) { return std::abs(p.x - 1.5) > 0.8 || std::abs(p.y - 1) > 0.8; });
  EXPECT_LT(points.size(), 1500u);
  const auto part = tessellation_of<2>(points);
  EXPECT_EQ(WindowPicture(whole, window).pixels(), WindowPicture(part, window).pixels());
}

TEST(PlaneWindowPicture, has_its_lines_in_the_panel_however_far_or_small_the_window_is) {
  const auto tessellation = tessellation_of<2>(random_points(200, 3));
  for (const PlaneWindow& window : std::vector<PlaneWindow>{{{1, 1}, {1 + 1e-9, 1 + 1e-9}},
                                                            {{-1e60, -1e60}, {1e60, 1e60}},
                                                            {{1e50, 1e50}, {2e50, 2e50}},
                                                            {{0, 0}, {3, 1e-3}},
                                                            {{0, 0}, {1e-3, 2}}}) {
    for (const PlotSize& size : {PlotSize{}, PlotSize{640, 480}, PlotSize{64, 64}}) {
      WindowPicture picture(tessellation, window, size);
      const PixelBox& panel = picture.panel;
      if (size.height > 0) {
        EXPECT_EQ(picture.canvas.height(), size.height);
      }
      for (int y = panel.y; y < picture.canvas.height(); ++y) {
        for (int x = 0; x < picture.canvas.width(); ++x) {
          if (ink_at(picture.canvas, x, y) == Ink::none) continue;
          EXPECT_TRUE(x >= panel.x && x < panel.right() && y < panel.bottom()) << x << " " << y;
        }
      }
    }
  }
}

TEST(TessellationPicture, hears_ctrl_c) {
  watch_for_interrupts();
  const auto plane = tessellation_of<2>(random_points(5, 1));
  const auto space = tessellation_of<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  std::raise(SIGINT);
  EXPECT_THROW(plane_picture(plane, own_number, image_file), Interrupted);
  EXPECT_THROW(space_picture(space, own_number, image_file, std::nullopt), Interrupted);
  forget_interrupt();
}

TEST(SpacePicture, does_not_depend_on_the_order_of_the_points) {
  std::vector<SpacePoint> points = random_space_points(20, 4);
  for (int i = 0; i < 8; ++i) points.push_back({i % 2 * 1.0, i / 2 % 2 * 1.0, i / 4 * 1.0});
  const auto picture = [](const Tessellation<3>& t) {
    return space_picture(
        t,
        [&t](PointId p) { return number_at(t.position(p).x, t.position(p).y + t.position(p).z); },
        image_file, std::nullopt);
  };
  const auto first = picture(tessellation_of<3>(points));
  std::shuffle(points.begin(), points.end(), std::mt19937_64(3));
  EXPECT_EQ(picture(tessellation_of<3>(points)), first);
}

TEST(SpacePicture, of_any_span_and_any_size_is_drawn) {
  const std::vector<std::vector<SpacePoint>> sets{
      {},
      {{1, 2, 3}},
      {{0, 0, 0}, {1, 1, 1}},
      {{0, 0, 0}, {1, 2, 3}, {2, 4, 6}},
      {{0, 0, 0}, {0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, {0.3, 0.6, 0.9}, {0.7, 1.4, 2.1}},
      {{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5}},
      {{0, 0, 0}, {1e60, 0, 0}, {0, 1e60, 0}, {0, 0, 1e60}, {1e-40, 1e-40, 1e-40}},
      {{4e6, 4e6, 4e6},
       {4e6 + 0x1p-30, 4e6, 4e6},
       {4e6, 4e6 + 0x1p-30, 4e6},
       {4e6, 4e6, 4e6 + 1e-8}}};
  const std::vector<std::optional<View>> views{
      std::nullopt, View{{1, 2, 3}, {4, 5, 6}}, View{{0, 0, 10}, {0, 0, 0}},
      View{{1e30, 1e30, -1e30}, {0.5, 0.5, 0.5}}, View{{1e30, 1e30, -1e30}, {-1e30, 1e30, 1e30}}};
  for (const auto& points : sets) {
    const auto tessellation = tessellation_of<3>(points);
    for (const auto& view : views) {
      const auto bytes = space_picture(tessellation, own_number, image_file, view);
      EXPECT_GT(bytes.size(), 1000u);
      EXPECT_EQ(std::string(bytes.begin() + 1, bytes.begin() + 4), "PNG");
    }
  }
}

TEST(SpacePicture, has_red_and_blue_inside_its_border_alone) {
  const auto tessellation = tessellation_of<3>(random_space_points(40, 1));
  const PixelBox panel = PlotSheet(1.35, PlotSheet::Margins::plain).panel();
  for (const auto& view : std::vector<std::optional<View>>{
           std::nullopt, View{{0.5, 0.5, 0.5}, {0.9, 0.6, 0.4}}, View{{9, 9, 9}, {0, 0, 0}}}) {
    PixelCanvas canvas = view_space(tessellation, own_number, view);
    int red = 0;
    int blue = 0;
    for (int y = panel.y; y < canvas.height(); ++y) {
      for (int x = 0; x < canvas.width(); ++x) {
        const Ink ink = ink_at(canvas, x, y);
        if (ink == Ink::none) continue;
        EXPECT_TRUE(x >= panel.x && x < panel.right() && y < panel.bottom()) << x << " " << y;
        ++(ink == Ink::red ? red : blue);
      }
    }
    EXPECT_GT(red, 2000);
    EXPECT_GT(blue, 2000);
  }
}

TEST(SpacePicture, needs_a_direction_to_look_in) {
  const auto tessellation = tessellation_of<3>(random_space_points(5, 1));
  try {
    space_picture(tessellation, own_number, image_file, View{{1, 2, 3}, {1, 2, 3}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("the same point"), std::string::npos);
  }
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(
      space_picture(tessellation, own_number, image_file, View{{1, 2, infinity}, {1, 2, 3}}),
      Error);
  EXPECT_THROW(space_picture({}, own_number, image_file, View{{1, 2, 3}, {1, 2, 3}}), Error);
}

}  // namespace
}  // namespace thiessen
