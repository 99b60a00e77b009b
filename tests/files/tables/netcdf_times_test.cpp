// How the times of a NetCDF of stations are counted, and what their bounds say of them.
#include "files/tables/netcdf_times.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/iso_time.h"
#include "base/temporary_folder.h"
#include "files/tables/netcdf_file.h"

namespace thiessen {
namespace {

std::int64_t moment(const char* time) {
  return clock_seconds(parse_iso_time(time).time);
}

TEST(NetcdfTimes, are_counted_from_a_moment_in_a_unit) {
  const auto hours = parse_time_unit("hours since 2020-01-01 06:00:00").unit.value();
  EXPECT_EQ(hours.seconds, 3600);
  EXPECT_EQ(hours.origin, moment("2020-01-01T06:00"));
  EXPECT_FALSE(hours.ahead_of_utc);
  for (const char* text :
       {"days since 1990-01-02", "days since 1990-1-2 0:0:0.0", "d since 1990-01-02T00:00:00Z",
        "Days Since 1990-01-02 00:00 UTC", "days since 1990-1-2 00:00:00 +0:00"}) {
    const auto days = parse_time_unit(text).unit.value();
    EXPECT_EQ(days.seconds, 86'400) << text;
    EXPECT_EQ(days.origin, moment("1990-01-02T00:00")) << text;
    EXPECT_FALSE(days.ahead_of_utc) << text;
  }
}

TEST(NetcdfTimes, may_be_of_a_zone) {
  const auto ahead = [](const std::string& zone) {
    const auto unit = parse_time_unit("hours since 2020-01-01 00:00:00" + zone).unit.value();
    EXPECT_EQ(unit.origin, moment("2020-01-01T00:00")) << zone;
    return unit.ahead_of_utc.value_or(0);
  };
  EXPECT_EQ(ahead(" +01:00"), 60);
  EXPECT_EQ(ahead("+01:00"), 60);
  EXPECT_EQ(ahead(" +1:00"), 60);
  EXPECT_EQ(ahead(" 1:00"), 60);
  EXPECT_EQ(ahead(" -0330"), -210);
  EXPECT_EQ(ahead(" -6"), -360);
  EXPECT_EQ(ahead(" GMT"), 0);
}

TEST(NetcdfTimes, are_refused_where_their_unit_is_not_known) {
  const ParsedTimeUnit months = parse_time_unit("months since 2000-01-01");
  EXPECT_FALSE(months.unit);
  EXPECT_EQ(months.fault, "times are counted in 'months', which is not known");
  EXPECT_TRUE(contains(months.hint.plain(), "days, hours, minutes or seconds"));
  for (const char* text :
       {"", "days", "decades since 2000-01-01", "days since", "days since yesterday",
        "days since 2000-13-01", "days since 2000-01-01 25:00", "days since 2000-01-01 00:00 MEZ",
        "days since 2000-01-01 00:00 +24:00", "days since 2000-01-01 00:00:0x",
        "days since 2000-01"})
    EXPECT_FALSE(parse_time_unit(text).unit) << text;
}

/// The times of a file as texts, and then what its bounds say.
std::vector<std::string> times_of(const NetcdfOfStations& file) {
  const TemporaryFolder folder;
  NetcdfStations stations(file.write(folder.path() + "/r.nc"));
  stations.find();
  const NetcdfTimes times(stations);
  std::vector<std::string> texts;
  const std::size_t begin = 0;
  const std::size_t size = file.times.size();
  for (const double time : times.read({&begin, 1}, {&size, 1}))
    texts.push_back(times.text_of(time));
  const auto stamp = times.stamp();
  texts.push_back(!stamp ? "" : *stamp == Stamp::begin ? "begin" : "end");
  texts.push_back(times.bounds_in_words());
  return texts;
}

using Texts = std::vector<std::string>;

TEST(NetcdfTimes, are_dates_where_all_are_midnights_counted_in_days) {
  EXPECT_EQ(times_of({.time_units = "days since 2020-02-28"}),
            (Texts{"2020-02-28", "2020-02-29", "2020-03-01", "", ""}));
  EXPECT_EQ(times_of({.time_units = "days since 2020-02-28", .times = {0, 1.0 / 144, 1}}),
            (Texts{"2020-02-28T00:00", "2020-02-28T00:10", "2020-02-29T00:00", "", ""}));
  EXPECT_EQ(times_of({.time_units = "days since 2020-02-28 12:00", .times = {0.5, 1.5, 2.5}}),
            (Texts{"2020-02-29", "2020-03-01", "2020-03-02", "", ""}));
}

TEST(NetcdfTimes, are_written_with_their_zone) {
  EXPECT_EQ(times_of({.time_units = "hours since 2020-01-01 00:00:00 +01:00", .times = {0, 1, 26}}),
            (Texts{"2020-01-01T00:00+01:00", "2020-01-01T01:00+01:00", "2020-01-02T02:00+01:00", "",
                   ""}));
}

TEST(NetcdfTimes, are_of_their_steps_what_their_bounds_say) {
  EXPECT_EQ(times_of({.times = {23, 24, 25}, .bounds = {22, 23, 23, 24, 24, 25}}),
            (Texts{"2020-01-01T23:00", "2020-01-02T00:00", "2020-01-02T01:00", "end",
                   "its times end their steps, as time_bnds has them"}));
  EXPECT_EQ(times_of({.times = {22, 23, 24}, .bounds = {22, 23, 23, 24, 24, 25}}),
            (Texts{"2020-01-01T22:00", "2020-01-01T23:00", "2020-01-02T00:00", "begin",
                   "its times begin their steps, as time_bnds has them"}));
  EXPECT_EQ(times_of({.times = {22.5, 23.5, 24.5}, .bounds = {22, 23, 23, 24, 24, 25}}),
            (Texts{"2020-01-01T22:00", "2020-01-01T23:00", "2020-01-02T00:00", "begin",
                   "its times are those at which time_bnds has its steps begin"}));
}

TEST(NetcdfTimes, that_end_days_are_no_dates) {
  const std::string days = "days since 2020-01-01";
  EXPECT_EQ(times_of({.time_units = days, .times = {1, 2, 3}, .bounds = {0, 1, 1, 2, 2, 3}}),
            (Texts{"2020-01-02T00:00", "2020-01-03T00:00", "2020-01-04T00:00", "end",
                   "its times end their steps, as time_bnds has them"}));
  EXPECT_EQ(times_of({.time_units = days, .times = {.5, 1.5, 2.5}, .bounds = {0, 1, 1, 2, 2, 3}}),
            (Texts{"2020-01-01", "2020-01-02", "2020-01-03", "begin",
                   "its times are those at which time_bnds has its steps begin"}));
}

TEST(NetcdfTimes, say_so_where_their_bounds_are_not_there) {
  EXPECT_EQ(times_of({.time_attributes = {{"bounds", "gone"}}}).back(),
            "the bounds of its times, 'gone', are not in it");
  EXPECT_EQ(times_of({.time_attributes = {{"bounds", "lon"}}}).back(),
            "the bounds of its times, 'lon', are no pairs");
}

}  // namespace
}  // namespace thiessen
