#include "report/report_legend.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "map/sheet/picture.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

/// Two gauges whose means are 5 and 15, between breaks that are given.
struct TwoGauges {
  explicit TwoGauges(ClassRule rule) {
    picture.by_rainfall = true;
    picture.classes = std::move(rule);
    for (std::size_t i = 0; i < 2; ++i) {
      const double x = static_cast<double>(i);
      picture.cells.push_back({{{{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}, {}}}, i, 5 + 10 * x, 0});
      picture.gauges.push_back({{x + 0.5, 0.5}, "", true, i == 0 ? "A" : "B"});
    }
    picture.basins.push_back({"Q", {{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {}}}});
    report.picture = &picture;
    report.unit = "mm";
    report.network = 2;
    report.series = &series;
  }
  TwoGauges(const TwoGauges&) = delete;
  TwoGauges& operator=(const TwoGauges&) = delete;

  std::string legend() const { return report_legend(report, classes_of_steps(report)); }

  Picture picture;
  ThinnedSeries series{1, 2};
  Report report;
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

ClassRule breaks(std::vector<double> values) {
  ClassRule rule;
  rule.kind = ClassRule::Kind::breaks;
  rule.breaks = std::move(values);
  return rule;
}

TEST(ReportLegend, has_the_classes_of_means_and_hides_those_of_steps) {
  TwoGauges study(breaks({10}));
  study.series.add("Monday", std::vector{10.0}, std::vector{0.0, 15.0});
  const std::string legend = study.legend();
  EXPECT_TRUE(has(legend, "<ul id=\"mean-classes\">\n<li>")) << legend;
  EXPECT_TRUE(has(legend, "<ul id=\"step-classes\" hidden>\n<li>")) << legend;
  EXPECT_TRUE(has(legend, "from 10 mm</li>")) << legend;
  EXPECT_TRUE(has(legend, "0 to 10 mm</li>")) << legend;
}

TEST(ReportLegend, says_where_classes_have_no_end) {
  ClassRule rule;
  rule.kind = ClassRule::Kind::equal;
  rule.range = {6, 12};
  const std::string legend = TwoGauges(rule).legend();
  EXPECT_TRUE(has(legend, "below ")) << legend;
  EXPECT_TRUE(has(legend, "from ")) << legend;
  EXPECT_FALSE(has(legend, "\u2264")) << legend;
}

TEST(ReportLegend, has_the_signs_that_the_map_has) {
  TwoGauges study(breaks({10}));
  study.series.add("Monday", std::vector{10.0}, std::vector{5.0, 15.0});
  EXPECT_TRUE(has(study.legend(), "rain gauge</li>"));
  EXPECT_FALSE(has(study.legend(), "no reading</li>"));
  EXPECT_FALSE(has(study.legend(), "gauge without any reading</li>"));
  study.series.add("Tuesday", std::vector{10.0}, std::vector{silent, 15.0});
  EXPECT_TRUE(has(study.legend(), "no reading</li>"));
  study.picture.gauges.push_back({{1, 1}, "", false, "C"});
  EXPECT_TRUE(has(study.legend(), "gauge without any reading</li>"));
}

TEST(ReportLegend, has_no_classes_of_steps_where_readings_are_left_out) {
  TwoGauges study(breaks({10}));
  ThinnedSeries series(1, 2, {.readings = 1});
  series.add("Monday", std::vector{10.0}, std::vector{5.0, 15.0});
  study.report.series = &series;
  EXPECT_FALSE(has(study.legend(), "step-classes"));
}

}  // namespace
}  // namespace thiessen
