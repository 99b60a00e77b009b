#include "cli/outputs/report_of.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/options/blocks/view_options.h"
#include "cli/options/option_list.h"
#include "cli/outputs/cell_features.h"
#include "cli/outputs/given_inputs.h"
#include "cli/outputs/picture_of.h"

namespace thiessen::cli {
namespace {

RainStep step_at(const std::string& time, double a, double b, double rainfall) {
  RainStep step;
  step.time = time;
  step.readings = {a, b};
  step.basins = {{rainfall, 2, 1}};
  return step;
}

/// The page of two steps, of which the means are 20 and 15.
std::string page_of(const GivenInputs& given, const Warnings& warnings) {
  const ArealRainfall rainfall(given.inputs.weighing(), {}, 1);
  Summary summary(given.inputs, rainfall.full_weights());
  StudyReport report(given.inputs);
  for (const RainStep& step :
       {step_at("2020-01-01", 10, 20, 16), step_at("2020-01-02", 30, 10, 18)}) {
    summary.add(step);
    report.add(step);
  }
  GaugeReadings mean;
  mean.readings = {20, 15};
  mean.label = "the mean";
  const Picture picture = picture_of(given.inputs, cells_of_network(given.inputs, 1), &mean,
                                     given.options(), ViewOptions());
  OptionList options;
  return report.page({.picture = &picture,
                      .summary = &summary,
                      .weights = &rainfall.full_weights(),
                      .options = &options,
                      .unit = "mm",
                      .gaps = Gaps::strict,
                      .has_totals = true},
                     warnings);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(StudyReport, tells_the_policy_for_gaps) {
  const GivenInputs given;
  const std::string page = page_of(given, {});
  EXPECT_TRUE(has(page, "have no value (strict)."));
  EXPECT_TRUE(has(page, R"("gaps":"strict")"));
}

// The weights are 0.4 and 0.6, of 40 in all.
TEST(StudyReport, shows_weights_and_series) {
  const GivenInputs given;
  const std::string page = page_of(given, {});
  EXPECT_TRUE(has(page, "<td>A</td><td class=\"n\">16.00</td><td class=\"n\">0.4000</td>"));
  EXPECT_TRUE(has(page, R"("times":["2020-01-01","2020-01-02"])"));
  EXPECT_TRUE(has(page, R"("readings":["10,20","30,10"])"));
  EXPECT_TRUE(has(page, R"("cells":[[0,0,0.4000,20.000],[1,0,0.6000,15.000]])"));
}

TEST(StudyReport, tells_findings_without_folders) {
  const GivenInputs given;
  Warnings warnings;
  warnings.add({"/some/where/rain.csv", 7, "it is <odd>", ""});
  const std::string page = page_of(given, warnings);
  EXPECT_TRUE(has(page, "<li>warning: rain.csv:7: it is &lt;odd&gt;</li>"));
  EXPECT_TRUE(has(page, "<li>readings: 2 time steps, 0.0 % missing</li>"));
  EXPECT_TRUE(has(page, "<li>step: 1 day, none lacks</li>"));
  EXPECT_TRUE(has(page, "the nearest gauge of each basin"));
}

}  // namespace
}  // namespace thiessen::cli
