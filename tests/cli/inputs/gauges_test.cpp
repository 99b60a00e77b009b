#include "cli/inputs/gauges.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "cli/inputs/given_rainfall.h"

namespace thiessen::cli {
namespace {

const std::string table = "time,A,B,C\n2013-08-01,1,4,7\n2013-08-02,3,,8\n2013-08-03,,,\n";

std::optional<GaugeReadings> shown(GivenRainfall& given, const std::string& time = "") {
  Inputs inputs = given.inputs();
  return shown_readings(inputs, given.study(), given.rainfall(), time, given.warnings);
}

TEST(Gauges, show_nothing_without_rainfall) {
  GivenRainfall given("");
  EXPECT_FALSE(shown(given));
}

TEST(Gauges, show_the_means_of_what_each_reports_where_no_time_is_given) {
  GivenRainfall given(table);
  EXPECT_EQ(shown(given)->readings, (std::vector<double>{2, 4, 7.5}));
}

TEST(Gauges, show_the_step_that_is_asked_for) {
  GivenRainfall given(table);
  const GaugeReadings step = shown(given, "2013-08-02").value();
  EXPECT_EQ(step.label, "2013-08-02");
  EXPECT_EQ(step.readings.at(0), 3);
  EXPECT_TRUE(std::isnan(step.readings.at(1)));
  EXPECT_EQ(step.readings.at(2), 8);
  EXPECT_TRUE(sentences_of(given.warnings).empty());
}

TEST(Gauges, warn_of_a_step_in_which_none_reports) {
  GivenRainfall given(table);
  EXPECT_TRUE(std::isnan(shown(given, "2013-08-03")->readings.at(0)));
  ASSERT_EQ(sentences_of(given.warnings).size(), 1U);
  EXPECT_TRUE(
      sentences_of(given.warnings)[0].ends_with("no gauge reports in the time step '2013-08-03'"));
}

TEST(Gauges, show_an_event_by_the_name_of_its_field) {
  GivenRainfall given("", {"--value-field", "storm"}, "id,x,y,storm\nA,0,2,5\nB,8,2,6\n");
  const GaugeReadings event = shown(given).value();
  EXPECT_EQ(event.label, "storm");
  EXPECT_EQ(event.readings, (std::vector<double>{5, 6}));
}

TEST(Gauges, show_several_steps_in_the_order_in_which_they_are_asked_for) {
  GivenRainfall given(table);
  Inputs inputs = given.inputs();
  const std::vector<std::string> times{"2013-08-02", "2013-08-01"};
  const auto steps = shown_steps(inputs, given.study(), given.rainfall(), times, given.warnings);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].readings.at(0), 3);
  EXPECT_EQ(steps[1].readings.at(0), 1);
}

TEST(Gauges, name_every_time_that_there_is_not) {
  GivenRainfall given(table);
  Inputs inputs = given.inputs();
  const std::vector<std::string> times{"2013-08-01", "2014-08-01", "1.8.2013"};
  const auto sentences = complaints_of(
      [&] { shown_steps(inputs, given.study(), given.rainfall(), times, given.warnings); });
  ASSERT_EQ(sentences.size(), 2U);
  EXPECT_TRUE(contains(sentences[0], "there is no time step '2014-08-01'")) << sentences[0];
  EXPECT_TRUE(contains(sentences[1], "there is no time step '1.8.2013'")) << sentences[1];
}

TEST(Gauges, law_1_a_unit_that_is_known_is_shown_and_none_may_be_said_beside_it) {
  EXPECT_EQ(unit_shown("", "mm", false, "r.csv"), "mm") << "the option's own default";
  EXPECT_EQ(unit_shown("", "in", true, "r.csv"), "in");
  EXPECT_EQ(unit_shown("in", "mm", false, "r.csv"), "in");
  EXPECT_EQ(unit_shown("in", "in", true, "r.csv"), "in");
  EXPECT_EQ(complaint_of([] { unit_shown("in", "mm", true, "r.csv"); }),
            "r.csv: the readings are in in, and --units says 'mm' | --to-unit brings them to "
            "another unit; --units is for what has none");
}

}  // namespace
}  // namespace thiessen::cli
