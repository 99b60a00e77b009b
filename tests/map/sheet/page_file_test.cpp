// Linked with OpenCV: pages are encoded.
#include "map/sheet/page_file.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "gdal/output/image_file.h"
#include "map/ink/recording_canvas.h"

namespace thiessen {
namespace {

const auto blank = [](Canvas&) {};

Page page_of(int width, int height) {
  Page page;
  page.width = width;
  page.height = height;
  return page;
}

Picture tagged() {
  Picture picture;
  picture.title = "Rain & snow";
  picture.tags = {{"software", "thiessen 9"}, {"metric", "planar"}, {"unit", "mm"}};
  return picture;
}

TEST(PageFile, is_of_the_format_that_is_wanted) {
  const Page page = page_of(90, 70);
  EXPECT_TRUE(page_file(page, {}, PictureFormat::png, image_file, blank).starts_with("\x89PNG"));
  EXPECT_TRUE(
      page_file(page, {}, PictureFormat::jpeg, image_file, blank).starts_with("\xFF\xD8\xFF"));
  EXPECT_TRUE(contains(page_file(page, {}, PictureFormat::svg, image_file, blank), "<svg "));
}

TEST(PageFile, law_1_is_drawn_once_on_a_canvas_of_the_pages_size) {
  for (const PictureFormat format : {PictureFormat::png, PictureFormat::jpeg, PictureFormat::svg}) {
    int drawn = 0;
    const std::string bytes =
        page_file(page_of(90, 70), {}, format, image_file, [&](Canvas& canvas) {
          ++drawn;
          EXPECT_EQ(canvas.width(), 90);
          EXPECT_EQ(canvas.height(), 70);
          canvas.fill({10, 10, 20, 20}, {200, 10, 20});
        });
    EXPECT_EQ(drawn, 1);
    EXPECT_NE(bytes, page_file(page_of(90, 70), {}, format, image_file, blank))
        << "what is drawn shows";
  }
}

TEST(PageFile, says_of_itself_what_the_picture_says) {
  const Page page = page_of(90, 70);
  const std::string svg = page_file(page, tagged(), PictureFormat::svg, image_file, blank);
  EXPECT_TRUE(contains(svg, "<title>Rain &amp; snow</title>")) << svg;
  EXPECT_TRUE(contains(svg, "thiessen 9; metric: planar; unit: mm")) << svg;
  const std::string png = page_file(page, tagged(), PictureFormat::png, image_file, blank);
  EXPECT_TRUE(contains(png, std::string("metric\0planar", 13)));
  const std::string jpeg = page_file(page, tagged(), PictureFormat::jpeg, image_file, blank);
  EXPECT_TRUE(contains(jpeg, "metric: planar"));
}

// 254 dots to the inch are 10 to the millimetre.
TEST(PageFile, says_its_density_where_one_is_known) {
  Picture picture;
  picture.dots_to_the_inch = 254;
  const Page page = page_of(90, 70);
  const std::string png = page_file(page, picture, PictureFormat::png, image_file, blank);
  EXPECT_TRUE(contains(png, std::string("pHYs\0\0\x27\x10\0\0\x27\x10\x01", 13)));
  EXPECT_FALSE(contains(page_file(page, {}, PictureFormat::png, image_file, blank), "pHYs"));
  const std::string svg = page_file(page, picture, PictureFormat::svg, image_file, blank);
  EXPECT_NE(svg, page_file(page, {}, PictureFormat::svg, image_file, blank));
}

TEST(PageFile, is_none_where_drawing_fails) {
  for (const PictureFormat format : {PictureFormat::png, PictureFormat::jpeg, PictureFormat::svg}) {
    EXPECT_THROW(page_file(page_of(90, 70), {}, format, image_file,
                           [](Canvas&) { throw std::runtime_error("no ink"); }),
                 std::runtime_error);
  }
}

/// Keeps which texts are drawn where, and as what.
class Head : public RecordingCanvas {
 public:
  using RecordingCanvas::RecordingCanvas;
  void text(const SetText& text, int x, int y, const Lettering& lettering) override {
    told.push_back(std::string(lettering.mark.kind) + " '" + text.text + "' at " +
                   std::to_string(x) + ", " + std::to_string(y));
  }
  std::vector<std::string> told;
};

SetText set(const std::string& text, int baseline) {
  SetText line;
  line.text = text;
  line.baseline = baseline;
  return line;
}

// The letters stand on the page's lines, wherever these are in the text's own rows.
TEST(PageFile, a_head_has_its_lines_on_the_rows_of_the_page) {
  Page page = page_of(300, 200);
  page.style.em = 16;
  page.title = {{set("Rain", 12), 40}, {set("of 2013", 15), 64}};
  page.subtitle = set("mean", 10);
  page.subtitle_baseline = 90;
  Head head(300, 200);
  draw_head(head, page);
  EXPECT_EQ(head.told,
            (std::vector<std::string>{"title 'Rain' at 16, 28", "title 'of 2013' at 16, 49",
                                      "subtitle 'mean' at 16, 80"}));
}

}  // namespace
}  // namespace thiessen
