// What tells the steps of a series from each other.
#include "results/step_key.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(StepKey, is_the_moment_however_it_is_written) {
  EXPECT_EQ(step_key("2020-01-01T06:00"), step_key("2020-01-01 06:00:00"));
  EXPECT_EQ(step_key("2020-01-01T24:00"), step_key("2020-01-02T00:00"));
  EXPECT_EQ(step_key("2020-01-01T06:00Z"), step_key("2020-01-01T07:00+01:00"));
  EXPECT_EQ(hash_of(step_key("2020-01-01T06:00Z")), hash_of(step_key("2020-01-01T07:00+01:00")));
  EXPECT_NE(step_key("2020-01-01T06:00"), step_key("2020-01-01T06:00Z"));
  EXPECT_NE(step_key("2020-01-01T06:00"), step_key("2020-01-01T06:00:00.5"));
}

TEST(StepKey, is_the_text_where_that_is_no_moment) {
  EXPECT_EQ(step_key("storm"), step_key("storm"));
  EXPECT_NE(step_key("31.12.2020"), step_key("01.01.2021"));
  EXPECT_NE(step_key("2020"), step_key("2020a"));
}

TEST(StepKey, tells_the_order_of_moments) {
  EXPECT_TRUE(comes_before(step_key("2020-01-01"), step_key("2020-01-02")));
  EXPECT_FALSE(comes_before(step_key("2020-01-02"), step_key("2020-01-02")));
  EXPECT_TRUE(comes_before(step_key("2020-01-01T00:00:00.2"), step_key("2020-01-01T00:00:00.25")));
  EXPECT_FALSE(comes_before(step_key("a"), step_key("b")));
}

TEST(StepKey, tells_what_may_stand_in_one_series) {
  EXPECT_TRUE(are_alike(step_key("2020-01-01"), step_key("2021-12-31")));
  EXPECT_FALSE(are_alike(step_key("2020-01-01"), step_key("2020-01")));
  EXPECT_FALSE(are_alike(step_key("2020-01-01T00:00"), step_key("2020-01-01T00:00Z")));
  EXPECT_FALSE(are_alike(step_key("2020-01-01"), step_key("31.12.2020")));
}

}  // namespace
}  // namespace thiessen
