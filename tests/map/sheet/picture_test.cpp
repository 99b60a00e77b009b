#include "map/sheet/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "gdal/output/image_file.h"
#include "map/sheet/row_of_cells.h"

namespace thiessen {
namespace {

std::string png(const Picture& picture) {
  Warnings warnings;
  return encode_picture(picture, PictureFormat::png, image_file, warnings);
}

/// Width or height from a PNG file's header chunk (ISO 15948, 11.2.2).
int png_side(const std::string& bytes, std::size_t offset) {
  int value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value * 256 + static_cast<unsigned char>(bytes[offset + i]);
  return value;
}

int png_width(const std::string& bytes) {
  return png_side(bytes, 16);
}
int png_height(const std::string& bytes) {
  return png_side(bytes, 20);
}

TEST(Picture, sizes_outside_the_limits_are_errors_that_name_them) {
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{
           {0, 0}, {1, 1}, {-5, 100}, {100, -5}, {1'000'000, 1'000'000}, {20'001, 0}, {64, 63}}) {
    try {
      check_picture_size(width, height);
      FAIL() << width << " x " << height;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("limits of 64 to 20000 pixels"), std::string::npos);
    }
  }
  EXPECT_THROW(check_picture_size(20'000, 20'000), Error) << "all pixels together";
  EXPECT_NO_THROW(check_picture_size(10'000, 10'000));
  EXPECT_NO_THROW(check_picture_size(64, 64));
  Picture picture = row_of_cells({1});
  picture.width = 1'000'000;
  EXPECT_THROW(png(picture), Error);
}

TEST(Picture, has_the_size_asked_for) {
  Picture picture = row_of_cells({1, 5, 9});
  for (const auto& [width, height] :
       std::vector<std::pair<int, int>>{{64, 64}, {400, 300}, {300, 900}, {1200, 100}}) {
    picture.width = width;
    picture.height = height;
    const std::string bytes = png(picture);
    EXPECT_EQ(png_width(bytes), width);
    EXPECT_EQ(png_height(bytes), height);
  }
  picture.height = 0;
  EXPECT_EQ(png_width(png(picture)), 1200);
}

TEST(Picture, any_shape_of_study_area_gives_a_picture_within_bounds) {
  for (const double stretch : {1e-9, 1e-6, 0.01, 1.0, 100.0, 1e6, 1e9}) {
    Picture picture;
    picture.width = 500;
    picture.basins.push_back({"", {{{{0, 0}, {stretch, 0}, {stretch, 1}, {0, 1}}, {}}}});
    picture.gauges.push_back({{stretch / 2, 0.5}, "g", true});
    const int height = png_height(png(picture));
    EXPECT_GE(height, 150);
    EXPECT_LE(height, 1000);
  }
}

TEST(Picture, is_the_same_bytes_again_and_in_another_locale) {
  Picture picture = row_of_cells({0.5, 1.25, none, 7.75});
  picture.subtitle = "ฝน 降雨量 مطر";
  const std::string first = png(picture);
  EXPECT_EQ(png(picture), first);
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "tr_TR.UTF-8", "ja_JP.UTF-8", "C.UTF-8"}) {
    if (std::setlocale(LC_ALL, locale) == nullptr) continue;
    EXPECT_EQ(png(picture), first) << locale;
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Picture, constant_missing_and_extreme_rainfall_are_drawn) {
  for (const auto& rainfall : std::vector<std::vector<double>>{
           {5, 5, 5}, {0, 0}, {none, none}, {none, 3}, {1e-300, 1e300}, {HUGE_VAL, 1}, {1e9, 0}}) {
    EXPECT_GT(png(row_of_cells(rainfall)).size(), 1000u);
  }
}

TEST(Picture, nothing_to_draw_is_still_a_picture) {
  Picture picture;
  EXPECT_GT(png(picture).size(), 500u);
  picture.geographic = true;
  EXPECT_GT(png(picture).size(), 500u);
  picture.gauges.push_back({{10, 50}, "lone", true});
  EXPECT_GT(png(picture).size(), 500u);
}

TEST(Picture, jpeg_begins_as_one) {
  Warnings warnings;
  const std::string bytes =
      encode_picture(row_of_cells({1, 2}), PictureFormat::jpeg, image_file, warnings);
  EXPECT_EQ(bytes.substr(0, 3), "\xFF\xD8\xFF");
}

std::string svg(const Picture& picture) {
  Warnings warnings;
  return encode_picture(picture, PictureFormat::svg, image_file, warnings);
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(Picture, an_svg_marks_cells_labels_unit_and_legend) {
  Picture picture = row_of_cells({3, 8, none});
  for (std::size_t i = 0; i < 3; ++i) picture.gauges[i].station = "S&" + std::to_string(i);
  const std::string text = svg(picture);
  EXPECT_EQ(count_of(text, "class=\"cell\""), 3u);
  EXPECT_EQ(count_of(text, "<path class=\"cell\" data-station=\"S&amp;1\" data-basin=\"B\""), 1u);
  EXPECT_EQ(count_of(text, "<text class=\"label\" data-station=\"S&amp;2\""), 1u);
  EXPECT_EQ(count_of(text, "(<tspan class=\"unit\">mm</tspan>)</text>"), 1u);
  EXPECT_EQ(count_of(text, "<g class=\"legend\">"), 1u);
  EXPECT_EQ(count_of(text, ">G1</text>"), 1u) << "text stays text";
  EXPECT_EQ(count_of(text, "<g"), count_of(text, "</g>"));
  EXPECT_EQ(svg(picture), text);
}

TEST(Picture, of_a_surface_fills_its_bands_and_draws_isohyets_with_their_levels) {
  Picture picture = row_of_cells({3, 8});
  picture.bands = {{square(0, 0, 1), 3}, {square(1, 0, 1), 7}};
  picture.surface = {3, 7, 12};
  picture.isohyets = {{"5", {{{0.2, 0.5}, {1.8, 0.6}}}}};
  const std::string text = svg(picture);
  EXPECT_EQ(count_of(text, "class=\"cell\""), 0u);
  EXPECT_EQ(count_of(text, "<path class=\"surface\""), 2u);
  EXPECT_EQ(count_of(text, "<g class=\"isohyet\" data-level=\"5\">"), 1u);
  EXPECT_GE(count_of(text, "<text class=\"isohyet-label\" data-level=\"5\""), 1u);
}

// Gauges read 0 and 8, the surface lies between 2 and 4: steps of a half from 2 to 4.
TEST(Picture, of_a_surface_has_its_classes_and_no_dry_ground_where_there_is_none) {
  Picture picture = row_of_cells({0, 8});
  EXPECT_EQ(count_of(svg(picture), ">dry</text>"), 1u);
  picture.bands = {{square(0, 0, 1), 2}, {square(1, 0, 1), 3}};
  picture.surface = {2, 2.5, 3, 3.5, 4};
  const std::string wet = svg(picture);
  EXPECT_EQ(count_of(wet, ">dry</text>"), 0u);
  EXPECT_EQ(count_of(wet, ">4.0</text>"), 1u);
  EXPECT_EQ(count_of(wet, ">8</text>"), 0u);
  picture.surface = {0, 2.5, 3, 3.5, 4};
  EXPECT_EQ(count_of(svg(picture), ">dry</text>"), 0u) << "a point of 0 is no ground";
  picture.bands[0].rainfall = 0;
  EXPECT_EQ(count_of(svg(picture), ">dry</text>"), 1u);
}

TEST(Picture, an_svg_has_a_circle_of_each_gauge_that_names_its_station) {
  Picture picture = row_of_cells({3, none});
  picture.gauges[0].station = "A";
  picture.gauges[1].station = "B";
  const std::string text = svg(picture);
  EXPECT_EQ(count_of(text, "<circle class=\"gauge\" data-station=\"A\""), 1u);
  EXPECT_EQ(count_of(text, "<circle class=\"gauge silent\" data-station=\"B\""), 1u);
}

/// The value of an attribute in an element of an SVG.
std::string attribute_of(const std::string& element, const std::string& name) {
  const std::size_t at = element.find(" " + name + "=\"");
  if (at == std::string::npos) return "";
  const std::size_t begin = at + name.size() + 3;
  return element.substr(begin, element.find('"', begin) - begin);
}

/// The elements of an SVG that begin so.
std::vector<std::string> elements_of(const std::string& text, const std::string& begin) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1))
    found.push_back(text.substr(at, text.find('>', at) - at));
  return found;
}

/// Gauges at random, some of them in clusters, in one basin of 3 by 2.
Picture random_network(unsigned seed, std::size_t gauges) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  std::normal_distribution<double> near(0, 0.06);
  Picture picture;
  picture.width = 500 + 150 * static_cast<int>(seed);
  picture.basins.push_back({"", {{{{0, 0}, {3, 0}, {3, 2}, {0, 2}}, {}}}});
  Point centre{1, 1};
  for (std::size_t i = 0; i < gauges; ++i) {
    Point p{3 * share(random), 2 * share(random)};
    if (i % 10 == 0) centre = p;
    if (i % 3 == 0) {
      p = {std::clamp(centre.x + near(random), 0.0, 3.0),
           std::clamp(centre.y + near(random), 0.0, 2.0)};
    }
    const std::string id = "N" + std::to_string(1000 + i);
    picture.gauges.push_back({p, id, i % 7 != 0, id});
  }
  return picture;
}

// Judged by what the SVG shows: the box of the letters, of capitals and digits, is 0.73 of their
// size high in DejaVu Sans and stands on the baseline.
TEST(Picture, no_label_is_as_near_to_another_dot_as_to_its_own) {
  constexpr double capital_height = 0.73;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const std::string text = svg(random_network(seed, 40 * seed));
    std::map<std::string, Point> dots;
    for (const std::string& dot : elements_of(text, "<circle class=\"gauge"))
      dots[attribute_of(dot, "data-station")] = {std::stod(attribute_of(dot, "cx")),
                                                 std::stod(attribute_of(dot, "cy"))};
    const auto labels = elements_of(text, "<text class=\"label\"");
    EXPECT_GT(labels.size(), 10u * seed) << "seed " << seed;
    for (const std::string& label : labels) {
      const double left = std::stod(attribute_of(label, "x"));
      const double foot = std::stod(attribute_of(label, "y"));
      const double right = left + std::stod(attribute_of(label, "textLength"));
      const double top = foot - capital_height * std::stod(attribute_of(label, "font-size"));
      const auto distance = [&](Point p) {
        return std::hypot(std::max({left - p.x, p.x - right, 0.0}),
                          std::max({top - p.y, p.y - foot, 0.0}));
      };
      const std::string station = attribute_of(label, "data-station");
      const double own = distance(dots.at(station));
      for (const auto& [other, dot] : dots) {
        if (other != station) {
          EXPECT_GT(distance(dot), 1.25 * own)
              << station << " and the dot of " << other << ", seed " << seed;
        }
      }
    }
  }
}

TEST(Picture, tells_in_one_line_what_has_no_room) {
  Picture picture = row_of_cells({1, 2, 3});
  picture.width = 300;
  picture.units = "thousandths of an inch per quarter of an hour";
  for (int i = 0; i < 3; ++i)
    picture.basins.push_back({"a name that is far too long", square(i, 0, 1)});
  Warnings warnings;
  encode_picture(picture, PictureFormat::png, image_file, warnings);
  ASSERT_EQ(warnings.notices().size(), 1u);
  const std::string told = warnings.notices()[0].text.plain();
  EXPECT_NE(told.find("the names of 4 of 4 basins"), std::string::npos) << told;
  EXPECT_NE(told.find("the end of the legend's heading"), std::string::npos) << told;
}

// 480 pixels across hold some thousands of dots, and not 24,000.
TEST(Picture, of_more_gauges_than_dots_have_room_shows_the_cells_alone_and_says_so) {
  Picture picture = row_of_cells({3, 8});
  for (int i = 0; i < 24'000; ++i) picture.gauges.push_back({{i / 12'000.0, 0.3}, "g", true});
  const std::string text = svg(picture);
  EXPECT_EQ(count_of(text, "<circle"), 0u);
  EXPECT_EQ(count_of(text, ">rain gauge</text>"), 0u);
  EXPECT_EQ(count_of(text, "not drawn: the 24002 gauges"), 1u);
  EXPECT_EQ(count_of(text, "class=\"cell\""), 2u);
}

TEST(Picture, an_svg_has_its_size_on_paper_by_its_density) {
  Picture picture = row_of_cells({1, 2});
  picture.width = 600;
  picture.height = 300;
  EXPECT_NE(svg(picture).find(" width=\"600\" height=\"300\""), std::string::npos);
  picture.dots_to_the_inch = 100;
  EXPECT_NE(svg(picture).find(" width=\"152.4mm\" height=\"76.2mm\""), std::string::npos);
}

TEST(Picture, an_svg_has_the_size_on_paper_that_was_asked_for) {
  Picture picture = row_of_cells({1, 2});
  picture.width = 3508;
  picture.height = 2480;
  picture.dots_to_the_inch = 300;
  picture.paper = {297, 210};
  EXPECT_NE(svg(picture).find(" width=\"297mm\" height=\"210mm\" viewBox=\"0 0 3508 2480\""),
            std::string::npos);
}

TEST(Picture, coordinates_that_are_not_finite_are_errors) {
  Picture picture = row_of_cells({1, 2});
  picture.cells[0].shape[0].outer[1].x = none;
  EXPECT_THROW(png(picture), Error);
  picture = row_of_cells({1, 2});
  picture.gauges[0].position.y = HUGE_VAL;
  EXPECT_THROW(png(picture), Error);
  picture = row_of_cells({1, 2});
  picture.basins[0].shape[0].outer[1].x = 1e200;
  EXPECT_THROW(png(picture), Error);
}

TEST(Picture, characters_that_no_font_has_are_warned_of) {
  Picture picture = row_of_cells({1, 2});
  picture.title = "a\U0010F123";
  Warnings warnings;
  encode_picture(picture, PictureFormat::png, image_file, warnings);
  ASSERT_EQ(warnings.messages().size(), 1u);
  EXPECT_NE(warnings.messages()[0].text.plain().find("no installed font"), std::string::npos);
}

TEST(Picture, a_thousand_gauges_at_one_place_are_drawn) {
  Picture picture = row_of_cells({1});
  for (int i = 0; i < 1000; ++i) picture.gauges.push_back({{0.5, 0.5}, "same", false});
  EXPECT_GT(png(picture).size(), 1000u);
}

}  // namespace
}  // namespace thiessen
