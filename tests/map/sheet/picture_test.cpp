#include "map/sheet/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <string>

#include "map/sheet/footer.h"
#include "map/sheet/legend.h"
#include "map/sheet/page.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

MultiPolygon square(double x, double y, double side) {
  return {{{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, {}}};
}

/// Square cells side by side, gauges in their middles, each with the rainfall given.
Picture row_of_cells(const std::vector<double>& rainfall) {
  Picture picture;
  picture.by_rainfall = true;
  picture.title = "Row";
  picture.units = "mm";
  picture.width = 480;
  for (std::size_t i = 0; i < rainfall.size(); ++i) {
    const double x = static_cast<double>(i);
    picture.cells.push_back({square(x, 0, 1), i, rainfall[i]});
    picture.gauges.push_back({{x + 0.5, 0.5}, "G" + std::to_string(i), std::isfinite(rainfall[i])});
  }
  const double length = static_cast<double>(rainfall.size());
  picture.basins.push_back({"B", {{{{0, 0}, {length, 0}, {length, 1}, {0, 1}}, {}}}});
  return picture;
}

std::string png(const Picture& picture) {
  Warnings warnings;
  return encode_picture(picture, PictureFormat::png, warnings);
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
  const std::string bytes = encode_picture(row_of_cells({1, 2}), PictureFormat::jpeg, warnings);
  EXPECT_EQ(bytes.substr(0, 3), "\xFF\xD8\xFF");
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
  encode_picture(picture, PictureFormat::png, warnings);
  ASSERT_EQ(warnings.messages().size(), 1u);
  EXPECT_NE(warnings.messages()[0].text.plain().find("no installed font"), std::string::npos);
}

TEST(Picture, a_thousand_gauges_at_one_place_are_drawn) {
  Picture picture = row_of_cells({1});
  for (int i = 0; i < 1000; ++i) picture.gauges.push_back({{0.5, 0.5}, "same", false});
  EXPECT_GT(png(picture).size(), 1000u);
}

TEST(RainfallClasses, a_value_takes_the_class_that_begins_at_or_below_it) {
  const RainfallClasses classes(row_of_cells({0, 0.1, 0.2, 1, none}));  // steps of 0.2
  ASSERT_EQ(classes.count(), 5u);
  EXPECT_EQ(classes.colour(0), classes.colour(0.1));
  EXPECT_NE(classes.colour(0.1), classes.colour(0.2));
  EXPECT_EQ(classes.colour(1), classes.colour(0.9)) << "the largest value is in the last class";
}

TEST(RainfallClasses, equal_values_make_one_class_and_none_make_none) {
  EXPECT_EQ(RainfallClasses(row_of_cells({4, 4})).count(), 1u);
  EXPECT_EQ(RainfallClasses(row_of_cells({none})).count(), 0u);
}

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

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

TEST(Page, its_parts_do_not_overlap_and_stay_on_it) {
  Typesetter type;
  Picture picture = row_of_cells({1, 2, none});
  picture.title = std::string(300, 'W');
  picture.subtitle = "mean over 120 months";
  picture.units = "a very long unit that nobody would use for rainfall";
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{
           {400, 0}, {400, 300}, {1600, 0}, {3000, 500}, {500, 3000}, {6000, 0}}) {
    picture.width = width;
    picture.height = height;
    const RainfallClasses classes(picture);
    const Legend legend(picture, classes, page_style(width, height), type);
    const Page page = lay_out(picture, {0, 0, 3, 1}, legend, type);
    ASSERT_FALSE(page.style.bare);
    EXPECT_EQ(page.width, width);
    EXPECT_TRUE(height == 0 || page.height == height);
    for (const PixelBox& box : {page.panel, page.legend, page.footer}) {
      EXPECT_TRUE(box.x >= 0 && box.y >= 0 && box.right() <= page.width &&
                  box.bottom() <= page.height);
      EXPECT_GT(box.width, 0);
      EXPECT_GT(box.height, 0);
    }
    EXPECT_FALSE(overlap(page.panel, page.legend));
    EXPECT_FALSE(overlap(page.panel, page.footer));
    EXPECT_FALSE(overlap(page.legend, page.footer));
    EXPECT_LE(page.style.em + page.title.width(), page.width - page.style.em);
    EXPECT_LE(page.subtitle_baseline, page.panel.y);
    EXPECT_LE(page.title_baseline, page.subtitle_baseline - page.subtitle.baseline);
  }
}

}  // namespace
}  // namespace thiessen
