#include "readings/joined_readings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "readings/readings_reader.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

const std::vector<Station> stations = {{"A", {}}, {"B", {}}};
constexpr double silent = std::numeric_limits<double>::quiet_NaN();

struct Step {
  std::string time;
  std::vector<double> readings;
};

/// The texts of CSV files, joined.
class Joined {
 public:
  explicit Joined(const std::vector<std::string>& texts, std::size_t memory = 1 << 20) {
    std::vector<JoinedReadings::File> files;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const std::string path = folder_.write(std::to_string(i) + ".csv", texts[i]);
      files.push_back({path, [path](Warnings& warnings) {
                         ReadingsOptions options;
                         options.is_one_of_several = true;
                         return open_readings(std::make_unique<CsvReader>(path), stations, {},
                                              options, warnings);
                       }});
    }
    JoinedReadings readings(std::move(files), "all", stations, warnings, memory);
    unit = readings.unit();
    TimeStep step;
    while (readings.next(step))
      steps.push_back({step.time, {step.readings.begin(), step.readings.end()}});
  }

  void expect(const std::vector<Step>& expected) const {
    ASSERT_EQ(steps.size(), expected.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
      EXPECT_EQ(steps[i].time, expected[i].time);
      for (std::size_t s = 0; s < stations.size(); ++s) {
        const double wanted = expected[i].readings[s];
        EXPECT_TRUE(steps[i].readings[s] == wanted ||
                    (std::isnan(steps[i].readings[s]) && std::isnan(wanted)))
            << steps[i].time << " " << stations[s].id << ": " << steps[i].readings[s];
      }
    }
  }

  std::vector<Step> steps;
  Warnings warnings;
  std::string unit;

 private:
  TemporaryFolder folder_;
};

TEST(JoinedReadings, of_a_file_a_year_come_in_the_order_of_time) {
  const Joined joined({"time,A,B\n2020-01-01,3,4\n2020-01-02,5,\n", "time,A,B\n2019-12-31,1,2\n"});
  joined.expect({{"2019-12-31", {1, 2}}, {"2020-01-01", {3, 4}}, {"2020-01-02", {5, silent}}});
  EXPECT_TRUE(joined.warnings.messages().empty());
  EXPECT_TRUE(joined.warnings.notices().empty());
}

TEST(JoinedReadings, of_a_file_a_station_and_of_other_layouts_are_one_step) {
  Joined(
      {"time,A\n2020-01-01,3\n2020-01-02,5\n", "station,time,value\nB,20200102,6\nB,20200103,7\n"})
      .expect({{"2020-01-01", {3, silent}}, {"2020-01-02", {5, 6}}, {"20200103", {silent, 7}}});
}

TEST(JoinedReadings, are_compared_by_the_calendar_where_their_texts_are_none_of_iso) {
  Joined({"time,A\n31/01/2020,3\n01/02/2020,5\n", "time,B\n2020-02-01,6\n"})
      .expect({{"31/01/2020", {3, silent}}, {"01/02/2020", {5, 6}}});
}

TEST(JoinedReadings, that_agree_count_once_and_a_gap_is_filled) {
  const Joined joined(
      {"time,A,B\n2020-01-01,3,\n2020-01-02,5,6\n", "time,A,B\n2020-01-02,5,6\n2020-01-01,3,4\n"});
  joined.expect({{"2020-01-01", {3, 4}}, {"2020-01-02", {5, 6}}});
  ASSERT_EQ(joined.warnings.notices().size(), 1U);
  EXPECT_EQ(joined.warnings.notices()[0].sentence(),
            "all: 3 readings stand in two files or more alike, and count once");
}

TEST(JoinedReadings, that_disagree_are_an_error_with_both_places) {
  const std::string complaint = complaint_of([] {
    Joined({"time,A,B\n2020-01-01,3,4\n2020-01-02,5,6\n", "time,A,B\n2020-01-02,5,6.5\n"});
  });
  EXPECT_TRUE(contains(complaint,
                       "1.csv:2: the reading of station 'B' at '2020-01-02' is 6.5, "
                       "and 6 in "));
  EXPECT_TRUE(contains(complaint, "0.csv:3"));
}

TEST(JoinedReadings, need_times_that_are_alike_of_their_steps) {
  const TemporaryFolder folder;
  const auto joined_stamp = [&](std::optional<Stamp> first, std::optional<Stamp> second) {
    std::vector<JoinedReadings::File> files;
    for (const auto& stamp : {first, second}) {
      const std::string day = std::to_string(files.size() + 1);
      const std::string path =
          folder.write(day + ".csv", "time,station,rain\n2020-01-0" + day + "T00:00,A,1\n");
      files.push_back({path, [path, stamp](Warnings& warnings) {
                         ReadingsOptions options;
                         options.is_one_of_several = true;
                         options.stamp = stamp;
                         return open_readings(std::make_unique<CsvReader>(path), stations, {},
                                              options, warnings);
                       }});
    }
    Warnings warnings;
    JoinedReadings readings(std::move(files), "all", stations, warnings);
    for (TimeStep step; readings.next(step);) EXPECT_EQ(readings.stamp(), first);
    return warnings.messages().size() - 1;  // but for B, which has no readings
  };
  EXPECT_EQ(joined_stamp(Stamp::end, Stamp::end), 0U);
  EXPECT_EQ(joined_stamp(Stamp::end, std::nullopt), 1U);
  EXPECT_TRUE(contains(complaint_of([&] { joined_stamp(Stamp::end, Stamp::begin); }),
                       "its times begin their steps, and those of"));
}

TEST(JoinedReadings, need_times_of_the_calendar_and_one_unit) {
  EXPECT_TRUE(contains(complaint_of([] {
                         Joined({"time,A\nstorm,3\n", "time,B\n2020-02-01,6\n"});
                       }),
                       "0.csv:2: time 'storm'"));
  const Joined joined({"station,time,rain_in\nA,2020-01-01,1\n", "time,B\n2020-01-01,6\n"});
  joined.expect({{"2020-01-01", {25.4, 6}}});
  EXPECT_EQ(joined.unit, "mm");
  ASSERT_EQ(joined.warnings.messages().size(), 1U);
  EXPECT_TRUE(contains(joined.warnings.messages()[0].sentence(), "no unit that is known"));
}

TEST(JoinedReadings, tell_of_stations_that_are_silent_in_all_files) {
  const Joined joined({"time,A,B\n2020-01-01,3,\n", "time,A,B\n2020-01-02,5,\n"});
  ASSERT_EQ(joined.warnings.messages().size(), 1U);
  EXPECT_TRUE(contains(joined.warnings.messages()[0].sentence(), "'B'"));
}

TEST(JoinedReadings, do_not_depend_on_what_fits_into_memory) {
  std::vector<std::string> texts;
  std::vector<Step> expected;
  for (int day = 1; day <= 28; ++day) {
    const std::string time = "2020-02-" + std::string(day < 10 ? "0" : "") + std::to_string(day);
    texts.push_back("time,A,B\n" + time + "," + std::to_string(day) + ",\n");
    texts.push_back("time,B\n" + time + ",7\n");
    expected.push_back({time, {static_cast<double>(day), 7}});
  }
  Joined({texts.rbegin(), texts.rend()}, 200).expect(expected);
}

}  // namespace
}  // namespace thiessen
