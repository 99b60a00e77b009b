#include "map/svg/svg_canvas.h"

#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <string>

namespace thiessen {
namespace {

constexpr Colour red{200, 10, 0};

SetText set_text(std::string text) {
  SetText set;
  set.ink = Coverage(40, 12);
  set.baseline = 10;
  set.text = std::move(text);
  set.size = 14;
  return set;
}

/// What is drawn between the background and the end of the document.
std::string body(const SvgCanvas& canvas) {
  const std::string all = canvas.document("", "");
  const std::string ground = "fill=\"#ffffff\"/>\n";
  const std::size_t from = all.find(ground) + ground.size();
  return all.substr(from, all.size() - from - std::string("</svg>\n").size());
}

TEST(SvgCanvas, a_document_has_its_size_in_pixels_or_on_paper) {
  const SvgCanvas canvas(300, 150);
  const std::string pixels = canvas.document("A & B", "made");
  EXPECT_TRUE(pixels.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns="));
  EXPECT_NE(pixels.find(" width=\"300\" height=\"150\" viewBox=\"0 0 300 150\""),
            std::string::npos);
  EXPECT_NE(pixels.find("<title>A &amp; B</title>"), std::string::npos);
  EXPECT_NE(pixels.find("<desc>made</desc>"), std::string::npos);
  const std::string paper = canvas.document("", "", {25.4, 12.7});
  EXPECT_NE(paper.find(" width=\"25.4mm\" height=\"12.7mm\" viewBox=\"0 0 300 150\""),
            std::string::npos);
}

TEST(SvgCanvas, areas_are_paths_with_their_marks) {
  SvgCanvas canvas(100, 100);
  const std::vector<Ring> rings{{{0, 0}, {10, 0}, {10, 10.126}}, {{1, 1}, {2, 1}, {2, 2}}};
  const Area area{{rings}, red, false, {"cell", "A\"1", "B<2"}};
  canvas.areas({&area, 1}, {}, {{5, 6, 50, 60}, {5, 6}});
  EXPECT_EQ(body(canvas),
            "<clipPath id=\"c1\"><rect x=\"5\" y=\"6\" width=\"50\" height=\"60\"/></clipPath>\n"
            "<g fill-rule=\"evenodd\" shape-rendering=\"crispEdges\" clip-path=\"url(#c1)\">\n"
            "<path class=\"cell\" data-station=\"A&quot;1\" data-basin=\"B&lt;2\" fill=\"#c80a00\" "
            "d=\"M5 6L15 6L15 16.13ZM6 7L7 7L7 8Z\"/>\n</g>\n");
}

TEST(SvgCanvas, a_hatched_area_is_filled_with_a_pattern) {
  SvgCanvas canvas(100, 100);
  const Ring ring{{0, 0}, {10, 0}, {10, 10}};
  const Area area{{{&ring, 1}}, red, true, {}};
  canvas.areas({&area, 1}, {{0, 0, 0}, 10, 2}, {{0, 0, 100, 100}, {0, 0}});
  EXPECT_NE(body(canvas).find("<pattern id=\"h1\""), std::string::npos);
  EXPECT_NE(body(canvas).find("width=\"7.07\" height=\"7.07\" patternTransform=\"rotate(45)\""),
            std::string::npos)
      << "10 along a row are 7.07 across the stripes";
  EXPECT_NE(body(canvas).find("<path fill=\"url(#h1)\""), std::string::npos);
}

TEST(SvgCanvas, lines_of_one_call_are_one_path) {
  SvgCanvas canvas(100, 100);
  const std::array<Point, 3> first{Point{0, 0}, Point{3, 4}, Point{3.001, 4.001}};
  const std::array<Point, 2> second{Point{7, 7}, Point{8, 9}};
  const std::vector<Polyline> lines{Polyline(first), Polyline(second)};
  canvas.lines(lines, {red, 1.5, 51, 6, 4}, {{0, 0, 100, 100}, {0, 0}});
  EXPECT_NE(body(canvas).find(
                "stroke=\"#c80a00\" stroke-width=\"1.5\" stroke-opacity=\"0.2\" "
                "stroke-dasharray=\"6 4\" clip-path=\"url(#c1)\" d=\"M0 0L3 4L3 4M7 7L8 9\"/>"),
            std::string::npos)
      << body(canvas);
}

TEST(SvgCanvas, text_stays_text) {
  SvgCanvas canvas(100, 100);
  canvas.text(set_text("Rain & (mm)"), 3, 4,
              {.colour = red, .mark = {.kind = "unit", .part = "mm"}});
  EXPECT_EQ(body(canvas),
            "<text x=\"3\" y=\"14\" font-size=\"14\" textLength=\"40\" fill=\"#c80a00\" "
            "xml:space=\"preserve\">Rain &amp; (<tspan class=\"unit\">mm</tspan>)</text>\n");
}

TEST(SvgCanvas, a_label_has_its_station_and_its_halo) {
  SvgCanvas canvas(100, 100);
  canvas.text(set_text("Name"), 3, 4, {red, 2, {"label", "S-1"}});
  EXPECT_NE(body(canvas).find("<text class=\"label\" data-station=\"S-1\" x=\"3\""),
            std::string::npos);
  EXPECT_NE(body(canvas).find("stroke-width=\"4\""), std::string::npos);
  EXPECT_NE(body(canvas).find(">Name</text>"), std::string::npos);
}

TEST(SvgCanvas, a_line_from_right_to_left_ends_where_its_ink_begins) {
  SvgCanvas canvas(100, 100);
  SetText text = set_text("אב");
  text.right_to_left = true;
  canvas.text(text, 3, 4, {red});
  EXPECT_NE(body(canvas).find(" x=\"3\" "), std::string::npos);
  EXPECT_NE(body(canvas).find(" direction=\"rtl\" text-anchor=\"end\""), std::string::npos);
}

TEST(SvgCanvas, groups_nest_and_boxes_are_rectangles) {
  SvgCanvas canvas(100, 100);
  {
    const Group outer(canvas, {"legend"});
    const Group inner(canvas, {"bar"});
    canvas.fill({1, 2, 3, 4}, red);
    canvas.border({10, 10, 20, 20}, red, 2);
    canvas.fill({1, 2, 0, 4}, red);
  }
  EXPECT_EQ(body(canvas),
            "<g class=\"legend\">\n<g class=\"bar\">\n"
            "<rect x=\"1\" y=\"2\" width=\"3\" height=\"4\" fill=\"#c80a00\"/>\n"
            "<rect x=\"11\" y=\"11\" width=\"18\" height=\"18\" fill=\"none\" stroke=\"#c80a00\" "
            "stroke-width=\"2\"/>\n</g>\n</g>\n");
}

TEST(SvgCanvas, a_disc_is_a_circle_and_cut_only_where_it_leaves_its_clip) {
  SvgCanvas canvas(100, 100);
  canvas.disc({10, 20}, 3.25, red, {0, 0, 100, 100});
  EXPECT_EQ(body(canvas), "<circle cx=\"10\" cy=\"20\" r=\"3.25\" fill=\"#c80a00\"/>\n");
  canvas.disc({10, 20}, 3.25, red, {10, 0, 100, 100});
  EXPECT_NE(body(canvas).find("clip-path=\"url(#c1)\"/>"), std::string::npos);
}

TEST(SvgCanvas, law_1_numbers_are_the_same_in_every_locale) {
  const auto drawn = [] {
    SvgCanvas canvas(100, 100);
    canvas.disc({10.5, -20.25}, 3.333, red, {-50, -50, 150, 150});
    return canvas.document("", "");
  };
  const std::string first = drawn();
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "tr_TR.UTF-8", "C.UTF-8"}) {
    if (std::setlocale(LC_ALL, locale) == nullptr) continue;
    EXPECT_EQ(drawn(), first) << locale;
  }
  std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
}  // namespace thiessen
