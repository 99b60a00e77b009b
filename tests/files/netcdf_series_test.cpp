#include "files/netcdf_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "files/netcdf_reading.h"

namespace thiessen {
namespace {

using Numbers = std::vector<double>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

ModelSubject subject_of(std::vector<std::string> basins) {
  ModelSubject subject;
  subject.basins = std::move(basins);
  for (std::size_t i = 0; i < subject.basins.size(); ++i)
    subject.centroids.push_back({10.5, 50.0 + static_cast<double>(i)});
  subject.made_by.software = "thiessen 9";
  subject.made_by.unit = "mm";
  subject.rainfall = "r.csv";
  subject.output = "rain.nc";
  return subject;
}

IsoTime at(const std::string& text) {
  return parse_iso_time(text).time;
}

// 2013-10-01 is day 15979 and 2014-10-01 day 16344.
TEST(NetcdfSeries, a_single_period_has_the_length_that_is_known) {
  const TemporaryFolder folder;
  Warnings told;
  ModelSubject subject = subject_of({"A"});
  subject.step = StepLength{12, 0};
  NetcdfSeries series(folder.path("a.nc"), std::move(subject), {}, false);
  series.add(at("2013-10"), Numbers{120}, {});
  series.finish(told);
  EXPECT_EQ(NetcdfReading(folder.path("a.nc")).numbers("time_bnds", 2),
            (Numbers{15'979.0 * 86'400, 16'344.0 * 86'400}));
}

TEST(NetcdfSeries, holds_basins_as_time_series_of_cf) {
  const TemporaryFolder folder;
  Warnings told;
  NetcdfSeries series(folder.path("a.nc"), subject_of({"A", "caf\xC3\xA9"}), {}, true);
  series.add(at("1970-01-01T01:00"), Numbers{0.1, 2}, Numbers{0.5, none});
  series.add(at("1970-01-01T02:00"), Numbers{3, none}, Numbers{0.25, 1});
  series.finish(told);
  const NetcdfReading found(folder.path("a.nc"));
  EXPECT_EQ(found.dimensions("rainfall"), "basin time");
  EXPECT_EQ(found.dimensions("standard_error"), "basin time");
  EXPECT_EQ(found.texts("basin_id", 2), (std::vector<std::string>{"A", "caf\xC3\xA9"}));
  const Numbers rainfall = found.numbers("rainfall", 4);
  EXPECT_EQ(Numbers(rainfall.begin(), rainfall.begin() + 3), (Numbers{0.1, 3, 2}));
  EXPECT_TRUE(std::isnan(rainfall[3]));
  const Numbers errors = found.numbers("standard_error", 4);
  EXPECT_EQ(errors[1], 0.25);
  EXPECT_TRUE(std::isnan(errors[2]));
  EXPECT_EQ(found.numbers("time", 2), (Numbers{3600, 7200}));
  EXPECT_EQ(found.numbers("time_bnds", 4), (Numbers{3600, 7200, 7200, 10800}));
  EXPECT_EQ(found.numbers("lat", 2), (Numbers{50, 51}));
  EXPECT_EQ(found.numbers("lon", 2), (Numbers{10.5, 10.5}));
  EXPECT_EQ(found.text("", "featureType"), "timeSeries");
  EXPECT_EQ(found.text("", "Conventions"), "CF-1.8");
  EXPECT_EQ(found.text("", "source"), "thiessen 9");
  EXPECT_EQ(found.text("basin_id", "cf_role"), "timeseries_id");
  EXPECT_EQ(found.text("rainfall", "units"), "mm");
  EXPECT_EQ(found.text("rainfall", "coordinates"), "basin_id lat lon");
  EXPECT_EQ(found.text("rainfall", "cell_methods"), "area: mean time: sum");
  EXPECT_EQ(found.text("rainfall", "ancillary_variables"), "standard_error");
  EXPECT_EQ(found.text("standard_error", "standard_name"),
            "thickness_of_rainfall_amount standard_error");
  EXPECT_EQ(found.text("time", "bounds"), "time_bnds");
  EXPECT_EQ(found.text("time", "units"), "seconds since 1970-01-01 00:00:00");
  EXPECT_EQ(found.text("lat", "standard_name"), "latitude");
}

TEST(NetcdfSeries, bounds_lie_before_times_that_end_their_steps) {
  const TemporaryFolder folder;
  Warnings told;
  ModelSubject subject = subject_of({"A"});
  subject.stamp = Stamp::end;
  NetcdfSeries series(folder.path("a.nc"), subject, {}, false);
  series.add(at("1970-01-01T01:00Z"), Numbers{1}, {});
  series.add(at("1970-01-01T02:00Z"), Numbers{1}, {});
  series.finish(told);
  const NetcdfReading found(folder.path("a.nc"));
  EXPECT_EQ(found.numbers("time", 2), (Numbers{3600, 7200}));
  EXPECT_EQ(found.numbers("time_bnds", 4), (Numbers{0, 3600, 3600, 7200}));
  EXPECT_EQ(found.text("time", "units"), "seconds since 1970-01-01 00:00:00 +00:00");
  EXPECT_FALSE(found.has("standard_error"));
  EXPECT_EQ(found.text("rainfall", "ancillary_variables"), "none");
}

TEST(NetcdfSeries, in_a_plane_of_its_own_has_x_and_y) {
  const TemporaryFolder folder;
  Warnings told;
  ModelSubject subject = subject_of({"A"});
  subject.centroids.clear();
  subject.unit = "buckets";
  NetcdfSeries series(folder.path("a.nc"), subject, {{3, 4}}, false);
  series.add(at("1970-01"), Numbers{1}, {});
  series.finish(told);
  const NetcdfReading found(folder.path("a.nc"));
  EXPECT_EQ(found.numbers("x", 1), (Numbers{3}));
  EXPECT_EQ(found.numbers("y", 1), (Numbers{4}));
  EXPECT_EQ(found.text("x", "standard_name"), "none");
  EXPECT_EQ(found.text("rainfall", "standard_name"), "none");
  EXPECT_EQ(found.text("rainfall", "coordinates"), "basin_id y x");
  EXPECT_EQ(found.numbers("time_bnds", 2), (Numbers{0, 31 * 86400})) << "a month is its own length";
}

TEST(NetcdfSeries, of_one_moment_has_no_bounds_and_says_so) {
  const TemporaryFolder folder;
  Warnings told;
  NetcdfSeries series(folder.path("a.nc"), subject_of({"A"}), {}, false);
  series.add(at("1970-01-01T01:00"), Numbers{1}, {});
  series.finish(told);
  EXPECT_FALSE(NetcdfReading(folder.path("a.nc")).has("time_bnds"));
  ASSERT_EQ(told.notices().size(), 1);
}

TEST(NetcdfSeries, of_many_steps_is_written_block_by_block) {
  const TemporaryFolder folder;
  Warnings told;
  constexpr std::size_t steps = 10'000;
  NetcdfSeries series(folder.path("a.nc"), subject_of({"A", "B"}), {}, false);
  for (std::size_t i = 0; i < steps; ++i) {
    IsoTime time = at("1970-01-01T00:00");
    time.day = 1 + static_cast<int>(i / 1440);
    time.hour = static_cast<int>(i / 60 % 24);
    time.minute = static_cast<int>(i % 60);
    const auto value = static_cast<double>(i);
    series.add(time, Numbers{value, -value}, {});
  }
  series.finish(told);
  const Numbers rainfall = NetcdfReading(folder.path("a.nc")).numbers("rainfall", 2 * steps);
  bool are_right = true;
  for (std::size_t i = 0; i < steps; ++i) {
    const auto value = static_cast<double>(i);
    are_right = are_right && rainfall[i] == value && rainfall[steps + i] == -value;
  }
  EXPECT_TRUE(are_right);
}

TEST(NetcdfSeries, refuses_times_of_which_some_have_a_zone) {
  const TemporaryFolder folder;
  NetcdfSeries series(folder.path("a.nc"), subject_of({"A"}), {}, false);
  series.add(at("1970-01-01T01:00"), Numbers{1}, {});
  EXPECT_TRUE(contains(complaint_of([&] { series.add(at("1970-01-01T02:00Z"), Numbers{1}, {}); }),
                       "some times have a zone"));
}

}  // namespace
}  // namespace thiessen
