#include "rainfall/series/time_bounds.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace thiessen {
namespace {

/// The bounds as texts of time_text, `begin/end`.
std::vector<std::string> texts(std::initializer_list<const char*> times,
                               const std::optional<StepLength>& step = {},
                               Stamp stamp = Stamp::begin) {
  std::vector<IsoTime> parsed;
  for (const char* time : times) parsed.push_back(parse_iso_time(time).time);
  std::vector<std::string> found;
  const auto text = [](double seconds) {
    return time_text(static_cast<std::int64_t>(seconds), TimePrecision::instant);
  };
  for (const TimeBounds& bounds : bounds_of(parsed, step, stamp))
    found.push_back(text(bounds.begin) + "/" + text(bounds.end));
  return found;
}

using Texts = std::vector<std::string>;

TEST(TimeBounds, a_step_is_as_long_as_the_file_s) {
  EXPECT_EQ(texts({"2020-02-28T18:00", "2020-02-29T18:00"}, StepLength{0, 21'600}),
            (Texts{"2020-02-28T18:00/2020-02-29T00:00", "2020-02-29T18:00/2020-03-01T00:00"}));
  EXPECT_EQ(texts({"2019-12-01", "2020-01-01"}, StepLength{1, 0}),
            (Texts{"2019-12-01T00:00/2020-01-01T00:00", "2020-01-01T00:00/2020-02-01T00:00"}));
  EXPECT_EQ(texts({"2020-01-31", "2020-02-29"}, StepLength{1, 0}),
            (Texts{"2020-01-31T00:00/2020-02-29T00:00", "2020-02-29T00:00/2020-03-31T00:00"}));
}

TEST(TimeBounds, without_a_step_a_date_lasts_to_its_end) {
  EXPECT_EQ(texts({"2020", "2021-02", "2021-12-31"}),
            (Texts{"2020-01-01T00:00/2021-01-01T00:00", "2021-02-01T00:00/2021-03-01T00:00",
                   "2021-12-31T00:00/2022-01-01T00:00"}));
}

TEST(TimeBounds, without_a_step_a_moment_lasts_until_the_next_later_one) {
  EXPECT_EQ(texts({"2020-01-01T05:00", "2020-01-01T00:00", "2020-01-01T02:00"}),
            (Texts{"2020-01-01T05:00/2020-01-01T08:00", "2020-01-01T00:00/2020-01-01T02:00",
                   "2020-01-01T02:00/2020-01-01T05:00"}));
  EXPECT_EQ(texts({"2020-01-01T05:00"}), (Texts{"2020-01-01T05:00/2020-01-01T05:00"}));
}

TEST(TimeBounds, are_in_utc_where_times_have_a_zone) {
  EXPECT_EQ(texts({"2020-01-01T00:00+02:00"}, StepLength{0, 3600}),
            (Texts{"2019-12-31T22:00/2019-12-31T23:00"}));
}

TEST(TimeBounds, lie_before_times_that_end_their_steps) {
  EXPECT_EQ(texts({"2020-02-29T00:00", "2020-02-29T06:00"}, StepLength{0, 21'600}, Stamp::end),
            (Texts{"2020-02-28T18:00/2020-02-29T00:00", "2020-02-29T00:00/2020-02-29T06:00"}));
  EXPECT_EQ(texts({"2020-03-01T00:00"}, StepLength{1, 0}, Stamp::end),
            (Texts{"2020-02-01T00:00/2020-03-01T00:00"}));
  EXPECT_EQ(texts({"2020-01-01T02:00", "2020-01-01T05:00", "2020-01-01T06:00"}, {}, Stamp::end),
            (Texts{"2019-12-31T23:00/2020-01-01T02:00", "2020-01-01T02:00/2020-01-01T05:00",
                   "2020-01-01T05:00/2020-01-01T06:00"}));
  EXPECT_EQ(texts({"2020-01-01"}, StepLength{0, 86'400}, Stamp::end),
            (Texts{"2020-01-01T00:00/2020-01-02T00:00"}))
      << "a date is the whole day";
}

}  // namespace
}  // namespace thiessen
