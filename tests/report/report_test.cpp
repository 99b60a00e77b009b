#include "report/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "map/sheet/picture.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

MultiPolygon unit_square(double x) {
  return {{{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}, {}}};
}

/// Two gauges, each with a square of a basin of two, and two steps.
struct TwoCells {
  explicit TwoCells(const std::string& first = "A", const std::string& basin = "Q") {
    picture.by_rainfall = true;
    picture.title = "Rain & <more>";
    picture.units = "mm per day";
    for (std::size_t i = 0; i < 2; ++i) {
      const double x = static_cast<double>(i);
      picture.cells.push_back({unit_square(x), i, 4 * (x + 1), 0});
      const std::string id = i == 0 ? first : "B";
      picture.gauges.push_back({{x + 0.5, 0.5}, id, true, id});
    }
    picture.basins.push_back({basin, {{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {}}}});
    series.add("Monday", std::vector{3.5}, std::vector{2.5, 4.5});
    series.add("Tuesday", std::vector{11.5}, std::vector{silent, 11.5});
    report.picture = &picture;
    report.unit = "mm";
    report.network = 2;
    report.places = {0, 1};
    BasinSummary summary;
    summary.basin = basin;
    summary.area = 2;
    summary.mean = 7.5;
    summary.standard_error = 1;
    summary.largest = 11.5;
    summary.most_influential = first;
    summary.influence = 0.5;
    report.basins.push_back(summary);
    report.weights = {{basin, first, 1, 0.5}, {basin, "B", 1, 0.5}};
    report.series = &series;
  }
  TwoCells(const TwoCells&) = delete;
  TwoCells& operator=(const TwoCells&) = delete;

  Picture picture;
  ThinnedSeries series{1, 2};
  Report report;
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(ReportPage, is_the_same_for_the_same_study) {
  EXPECT_EQ(report_page(TwoCells().report), report_page(TwoCells().report));
}

TEST(ReportPage, has_a_column_of_factors_where_normals_make_them) {
  TwoCells study;
  EXPECT_FALSE(has(report_page(study.report), ">factor</button>"));
  study.report.has_factors = true;
  study.report.weights.back().factor = 1.375;
  const std::string page = report_page(study.report);
  EXPECT_TRUE(has(page, ">factor</button>"));
  EXPECT_TRUE(has(page, "<td class=\"n\">0.5000</td><td class=\"n\">1.375</td></tr>"));
}

TEST(ReportPage, has_the_largest_depths_and_when_they_began) {
  TwoCells study;
  EXPECT_FALSE(has(report_page(study.report), ">most in "));
  study.report.unit = "mm/h";
  study.report.depth_unit = "mm";
  study.report.basins.front().depths = {{"1h", 11.5, "Tuesday"}, {"24h", {}, ""}};
  const std::string page = report_page(study.report);
  EXPECT_TRUE(has(page, ">most in 1h (mm)</button></th><th scope=\"col\">")) << page;
  EXPECT_TRUE(has(page,
                  "<td class=\"n\">0</td><td class=\"n\">11.50</td><td>Tuesday</td>"
                  "<td class=\"n\"></td><td></td></tr>"))
      << page;
}

TEST(ReportPage, has_no_part_left_open) {
  EXPECT_FALSE(has(report_page(TwoCells().report), "{{"));
}

TEST(ReportPage, holds_readings_with_the_decimals_that_they_carry) {
  const std::string page = report_page(TwoCells().report);
  EXPECT_TRUE(has(page, R"("readingDecimals":1)"));
  EXPECT_TRUE(has(page, R"("readings":["25,45",",115"])"));
  EXPECT_TRUE(has(page, R"("largest":["35,115"])"));
  EXPECT_TRUE(has(page, R"("times":["Monday","Tuesday"])"));
  EXPECT_TRUE(has(page, R"("cells":[[0,0,0.5000,4.0000],[1,0,0.5000,8.0000]])")) << page;
}

TEST(ReportPage, tells_the_bar_of_the_mean) {
  // 7.5 less and more 1.96.
  EXPECT_TRUE(has(report_page(TwoCells().report), ">5.540 to 9.460<"));
}

// "95 % bar of" and "the mean (mm)": 13 characters, and two for what is round them. "change, root",
// "root mean" and "square (mm)": 11.
TEST(ReportPage, gives_headings_room_for_a_few_lines) {
  const std::string page = report_page(TwoCells().report);
  EXPECT_TRUE(has(page, "style=\"min-width:15ch\">95 % bar of the mean (mm)<")) << page;
  EXPECT_TRUE(has(page, "style=\"min-width:13ch\">change, root mean square (mm)<")) << page;
}

TEST(ReportPage, tells_which_gauges_are_silent) {
  const std::string page = report_page(TwoCells().report);
  EXPECT_TRUE(has(page, "<th scope=\"row\">A</th><td class=\"n\">1</td><td class=\"n\">50.0</td>"));
  EXPECT_TRUE(has(page, "1 of 2 gauges report in every step"));
}

TEST(ReportPage, says_whose_cells_are_shown_and_what_silence_changes) {
  TwoCells study;
  EXPECT_TRUE(has(report_page(study.report),
                  "Cells and weights are those of the full network. Where gauges are silent at a "
                  "step, their ground goes to those around them that report (retessellate)."));
  study.report.gaps = Gaps::renormalise;
  EXPECT_TRUE(has(report_page(study.report), "are scaled up to 1 (renormalise)."));
  study.report.gaps = Gaps::strict;
  EXPECT_TRUE(has(report_page(study.report), "have no value (strict)."));
}

TEST(ReportPage, takes_no_text_for_markup) {
  const std::string evil = "</script><img src=x onerror=alert(1)>{{css}}\"'&\xE2\x80\xA8";
  TwoCells study(evil, evil);
  study.report.findings = {evil};
  study.report.options = evil;
  study.report.made_by = {{evil, evil}};
  study.report.inputs = {{evil, evil, evil}};
  const std::string page = report_page(study.report);
  EXPECT_FALSE(has(page, "<img"));
  EXPECT_EQ(count_of(page, "</script>"), 2U);
  EXPECT_EQ(count_of(page, ":root {"), count_of(report_page(TwoCells().report), ":root {"));
  EXPECT_TRUE(has(page, "Rain &amp; &lt;more&gt;"));
}

TEST(ReportPage, draws_a_cell_in_steps_of_whole_numbers) {
  // 9,700 across for two squares: the first spans 4,850 from the margin of 150.
  const std::string page = report_page(TwoCells().report);
  EXPECT_TRUE(has(page, "data-station=\"A\" data-basin=\"Q\"")) << page;
  EXPECT_TRUE(has(page, " d=\"M150 5000l4850 0 0-4850-4850 0z\"")) << page;
}

TEST(ReportPage, draws_no_line_where_the_antimeridian_cuts_a_cell) {
  TwoCells study;
  EXPECT_TRUE(has(report_page(study.report), "<g id=\"edges\">\n</g>")) << "no cell is cut";
  // A cap round the pole, whose ring runs up the antimeridian and along the pole.
  study.picture.geographic = true;
  const MultiPolygon cap{
      {{{-180, 60}, {-90, 60}, {0, 60}, {90, 60}, {180, 60}, {180, 90}, {-180, 90}}, {}}};
  study.picture.cells = {{cap, 0, 4, 0}};
  study.picture.basins = {{"Q", cap}};
  study.picture.gauges.resize(1);
  study.picture.gauges[0].position = {0, 80};
  const std::string page = report_page(study.report);
  EXPECT_TRUE(has(page, "class=\"cell cut\""));
  const std::size_t edges = page.find("<path data-cell=\"0\" d=\"M");
  ASSERT_NE(edges, std::string::npos);
  const std::string path = page.substr(edges, page.find("/>", edges) - edges);
  EXPECT_FALSE(has(path, "z")) << path;
  EXPECT_EQ(count_of(path, "M"), 1U) << path;
}

TEST(ReportPage, says_where_it_is_thinned) {
  TwoCells study;
  EXPECT_TRUE(has(report_page(study.report), "id=\"thinned\"></p>"));
  ThinnedSeries series(1, 2, {.values = 24, .most = 24, .fewest = 24});
  for (int i = 0; i < 100; ++i)
    series.add(std::to_string(i), std::vector{1.0 * i}, std::vector{1.0 * i, 1.0});
  study.report.series = &series;
  const std::string page = report_page(study.report);
  EXPECT_TRUE(has(page, "of 100 time steps each 4 are shown as one"));
  EXPECT_TRUE(has(page, R"("begins":["0","4","8",)")) << "where stretches begin";
  EXPECT_TRUE(has(page, R"("times":["3","7","11",)")) << "their wettest steps";
  EXPECT_TRUE(has(page, "rain.csv has all steps"));
  study.report.has_totals = true;
  const std::string totals = report_page(study.report);
  EXPECT_TRUE(has(totals, "rain.csv has totals over periods, not the steps"));
  EXPECT_FALSE(has(totals, "all steps"));
}

TEST(ReportPage, says_where_readings_are_left_out) {
  TwoCells study;
  ThinnedSeries series(1, 2, {.readings = 3});
  series.add("a", std::vector{1.0}, std::vector{1.0, 1.0});
  series.add("b", std::vector{1.0}, std::vector{1.0, 1.0});
  study.report.series = &series;
  const std::string page = report_page(study.report);
  EXPECT_TRUE(has(page, "the map shows the means over all steps"));
  EXPECT_FALSE(has(page, "\"readings\":["));
}

}  // namespace
}  // namespace thiessen
