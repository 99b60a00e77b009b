// Steps that come again are passed over.
#include "readings/steps/fresh_readings.h"

#include <gtest/gtest.h>

#include "readings/table_readings.h"

namespace thiessen {
namespace {

using namespace table_readings;

Outcome fed(const std::string& table) {
  Reader reader({"A", "B"});
  reader.options.steps_may_come_again = true;
  return reader.read(table);
}

TEST(FreshReadings, pass_over_steps_that_come_again) {
  const Outcome outcome =
      fed("time,A,B\n2020-01-01,5,4\n2020-01-02,7,\n2020-01-02,7,\n"
          "2020-01-01,5,4\n2020-01-03,7,2\n");
  expect_readings(outcome, {"2020-01-01", "2020-01-02", "2020-01-03"},
                  {{5, 4}, {7, silent}, {7, 2}});
  EXPECT_EQ(outcome.warnings, Texts{});
}

TEST(FreshReadings, keep_what_came_first_and_tell_of_other_readings_once) {
  const Outcome outcome = fed("time,A,B\n2020-01-01,5,4\n2020-01-01,5,3\n2020-01-01,5,2\n");
  expect_readings(outcome, {"2020-01-01"}, {{5, 4}});
  EXPECT_EQ(outcome.warnings,
            Texts{"r.csv:3: time '2020-01-01' comes again with other readings, which are passed "
                  "over, as are those of all steps that come again: what came first stays"});
}

TEST(FreshReadings, let_counters_go_on_from_the_last_new_step) {
  Reader reader({"A", "B"});
  reader.options.steps_may_come_again = true;
  reader.options.cumulative = true;
  expect_readings(reader.read("time,A,B\n2020-01-01,5,4\n2020-01-02,7,4\n2020-01-01,5,4\n"
                              "2020-01-03,8,6\n"),
                  {"2020-01-01", "2020-01-02", "2020-01-03"}, {{silent, silent}, {2, 0}, {1, 2}});
}

}  // namespace
}  // namespace thiessen
