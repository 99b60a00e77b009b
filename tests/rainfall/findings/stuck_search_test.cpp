#include "rainfall/findings/stuck_search.h"

#include <gtest/gtest.h>

#include "rainfall/findings/ring_of_gauges.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

Texts times_found(const ShownSteps& steps) {
  Texts times;
  for (const ReadingFinding& finding : steps.found) times.push_back(finding.time);
  return times;
}

TEST(StuckSearch, finds_all_readings_of_a_run_that_is_long_enough) {
  StuckSearch search(2, 3);
  ShownSteps steps(search);
  steps.show("1", {1, 2}, false);
  steps.show("2", {2, 2});
  steps.show("3", {2, 2});
  EXPECT_EQ(times_found(steps), (Texts{"1", "2", "3"}));  // of the second gauge
  steps.show("4", {2, 3});
  EXPECT_EQ(times_found(steps), (Texts{"1", "2", "3", "2", "3", "4"}));
  steps.show("5", {2, 3});
  EXPECT_EQ(times_found(steps), (Texts{"1", "2", "3", "2", "3", "4", "5"}));
  EXPECT_EQ(steps.found[6].station, StationIndex{0});
  EXPECT_EQ(steps.found[6].value, 2);
  EXPECT_TRUE(std::isnan(steps.found[6].expected));
}

TEST(StuckSearch, takes_no_zeros) {
  StuckSearch search(1, 3);
  ShownSteps steps(search);
  for (const char* time : {"1", "2", "3", "4"}) steps.show(time, {0});
  EXPECT_TRUE(steps.found.empty());
}

TEST(StuckSearch, ends_runs_at_silence_at_zero_and_where_steps_lack) {
  StuckSearch search(1, 3);
  ShownSteps steps(search);
  steps.show("1", {1});
  steps.show("2", {1});
  steps.show("3", {silent});
  steps.show("4", {1});
  steps.show("5", {1});
  steps.show("6", {0});
  steps.show("7", {1});
  steps.show("8", {1});
  steps.show("10", {1}, false);
  steps.show("11", {1});
  EXPECT_TRUE(steps.found.empty());
  steps.show("12", {1});
  EXPECT_EQ(times_found(steps), (Texts{"10", "11", "12"}));
}

}  // namespace
}  // namespace thiessen
