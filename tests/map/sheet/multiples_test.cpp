// Linked with OpenCV: maps are drawn.
#include "map/sheet/multiples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "gdal/output/image_file.h"
#include "map/sheet/row_of_cells.h"

namespace thiessen {
namespace {

std::vector<Picture> three_maps() {
  std::vector<Picture> maps = {row_of_cells({1, 2}), row_of_cells({30, 4}),
                               row_of_cells({0, none})};
  for (std::size_t i = 0; i < maps.size(); ++i) {
    maps[i].subtitle = "step " + std::to_string(i);
    maps[i].width = 900;
  }
  return maps;
}

std::string drawn(const std::vector<Picture>& maps, PictureFormat format) {
  Warnings warnings;
  return encode_multiples(maps, format, image_file, warnings);
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(Multiples, each_map_has_its_heading_and_all_share_title_legend_and_scale_bar) {
  const std::string text = drawn(three_maps(), PictureFormat::svg);
  EXPECT_EQ(count_of(text, "<g class=\"map\">"), 3u);
  for (const char* heading : {">step 0</text>", ">step 1</text>", ">step 2</text>"})
    EXPECT_EQ(count_of(text, heading), 1u) << heading;
  EXPECT_EQ(count_of(text, "class=\"title\""), 1u);
  EXPECT_EQ(count_of(text, "class=\"legend\""), 1u);
  EXPECT_EQ(count_of(text, "class=\"cell\""), 6u);
  EXPECT_EQ(count_of(text, ">dry</text>"), 1u);
  EXPECT_EQ(count_of(text, ">silent gauge</text>"), 1u);
  EXPECT_EQ(count_of(text, " units</text>"), 1u) << "the end of the scale bar";
}

// Of 1, 2, 4 and 30 the largest is over four times the median, 3: the classes are quantiles.
TEST(Multiples, have_the_classes_of_all_their_values_together) {
  const std::vector<Picture> maps = three_maps();
  const RainfallClasses classes = classes_of(maps);
  EXPECT_EQ(classes.ticks(), RainfallClasses({0, 1, 2, 4, 30}, {}).ticks());
  EXPECT_NE(classes.ticks(), classes_of(maps.front()).ticks());
  EXPECT_TRUE(classes.has_dry());
}

TEST(Multiples, of_one_map_are_its_picture) {
  const Picture picture = row_of_cells({1, 5});
  Warnings warnings;
  EXPECT_EQ(drawn({picture}, PictureFormat::png),
            encode_picture(picture, PictureFormat::png, image_file, warnings));
}

TEST(Multiples, are_the_same_bytes_again) {
  EXPECT_EQ(drawn(three_maps(), PictureFormat::png), drawn(three_maps(), PictureFormat::png));
  EXPECT_EQ(drawn(three_maps(), PictureFormat::jpeg).substr(0, 3), "\xFF\xD8\xFF");
}

TEST(Multiples, of_hundreds_of_gauges_leave_out_dots_and_names_and_say_so) {
  std::vector<Picture> maps = three_maps();
  for (Picture& map : maps) {
    for (int i = 0; i < 2000; ++i) map.gauges.push_back({{0.001 * i, 0.7}, "far", true});
  }
  const std::string text = drawn(maps, PictureFormat::svg);
  EXPECT_EQ(count_of(text, "<circle"), 0u);
  EXPECT_EQ(count_of(text, ">rain gauge</text>"), 0u);
  EXPECT_EQ(count_of(text, "not drawn: the 2002 gauges"), 1u);
  EXPECT_EQ(count_of(drawn(three_maps(), PictureFormat::svg), "class=\"label\""), 6u);
}

/// The smallest size of type in an SVG, in pixels.
double least_type(const std::string& svg) {
  const std::string attribute = "font-size=\"";
  double least = HUGE_VAL;
  for (std::size_t at = svg.find(attribute); at != std::string::npos;
       at = svg.find(attribute, at + 1))
    least = std::min(least, std::stod(svg.substr(at + attribute.size(), 8)));
  return least;
}

// A4 at 300 dots to the inch, on which five points are 20.8 dots.
TEST(Multiples, on_paper_have_no_type_below_five_points_and_no_names_where_these_have_no_room) {
  std::vector<double> rainfall(25, 3);
  rainfall.back() = 8;
  std::vector<Picture> maps(24, row_of_cells(rainfall));
  for (Picture& map : maps) {
    map.subtitle = "2017-03-25T06:00:00Z";
    map.width = 3508;
    map.height = 2480;
    map.dots_to_the_inch = 300;
    map.isohyets = {{"4", {{{0, 0.5}, {8, 0.5}}}}};
  }
  const std::string many = drawn(maps, PictureFormat::svg);
  EXPECT_GE(least_type(many), 20.8);
  EXPECT_EQ(count_of(many, "class=\"label\""), 0U);
  EXPECT_EQ(count_of(many, ">not labelled: too many for small maps</text>"), 1U);
  maps.resize(2);
  const std::string two = drawn(maps, PictureFormat::svg);
  EXPECT_GE(least_type(two), 20.8);
  EXPECT_GT(count_of(two, "class=\"label\""), 10U);
}

}  // namespace
}  // namespace thiessen
