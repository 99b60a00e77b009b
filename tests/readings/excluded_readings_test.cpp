#include "readings/excluded_readings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

const std::vector<Station> stations{{"A", {0, 0}}, {"B", {1, 0}}, {"C", {2, 0}}};
const std::vector<std::string> filtered{"F"};

/// Steps of three gauges which read 1, 2 and 3; some times are told by the reader.
class ThreeGauges : public Readings {
 public:
  explicit ThreeGauges(Texts times) : times_(std::move(times)) {}
  bool next(TimeStep& step) override {
    if (done_ == times_.size()) return false;
    step = {times_[done_++], readings_};
    if (step.time == "2/1/2020")
      step.written = WrittenTime{parse_iso_time("2020-01-02"), {}, {}, false};
    return true;
  }

 private:
  Texts times_;
  std::vector<double> readings_{1, 2, 3};
  std::size_t done_ = 0;
};

struct Outcome {
  std::vector<std::vector<double>> steps;  ///< with -1 for what is missing
  Texts notices;
  Texts warnings;
};

Outcome read(const std::vector<ExclusionList::Row>& rows, const Texts& times,
             bool ignore_unknown = false) {
  Outcome outcome;
  Warnings warnings;
  const ReadingsStations known(stations, filtered);
  Exclusions excluded({"f.csv", rows}, known, ignore_unknown, warnings);
  ExcludedReadings readings(std::make_unique<ThreeGauges>(times), std::move(excluded), warnings);
  for (TimeStep step; readings.next(step);) {
    std::vector<double>& kept = outcome.steps.emplace_back();
    for (const double reading : step.readings) kept.push_back(std::isnan(reading) ? -1 : reading);
  }
  for (const Message& message : warnings.notices()) outcome.notices.push_back(message.sentence());
  for (const Message& message : warnings.messages()) outcome.warnings.push_back(message.sentence());
  return outcome;
}

TEST(ExcludedReadings, count_as_missing_and_no_others) {
  const Outcome outcome = read({{"B", "2020-01-01", 2}}, {"2020-01-01", "2020-01-03"});
  EXPECT_EQ(outcome.steps, (std::vector<std::vector<double>>{{1, -1, 3}, {1, 2, 3}}));
  EXPECT_EQ(outcome.notices, (Texts{"f.csv: 1 reading counts as missing"}));
}

TEST(ExcludedReadings, are_all_of_a_gauge_where_no_time_is_told) {
  const Outcome outcome = read({{"C", "", 2}, {"A", "x", 3}, {"C", "y", 4}}, {"x", "y"});
  EXPECT_EQ(outcome.steps, (std::vector<std::vector<double>>{{-1, 2, -1}, {1, 2, -1}}));
  EXPECT_EQ(outcome.notices, (Texts{"f.csv: 2 readings and all of 1 gauge count as missing"}));
}

TEST(ExcludedReadings, are_named_by_their_moment_too) {
  const Outcome outcome =
      read({{"A", "2020-01-02", 2}, {"B", "2020-01-04T00:00", 3}}, {"2/1/2020", "20200104T0000"});
  EXPECT_EQ(outcome.steps, (std::vector<std::vector<double>>{{-1, 2, 3}, {1, -1, 3}}));
}

TEST(ExcludedReadings, that_are_not_there_are_counted) {
  const Outcome outcome =
      read({{"A", "2020", 2}, {"A", "2021", 3}, {"A", "2021", 4}, {"F", "2020", 5}}, {"2020"});
  EXPECT_EQ(outcome.notices,
            (Texts{"f.csv: 1 reading counts as missing; 1 more that it names are not there; 1 row "
                   "is of stations without a part in the network"}));
}

TEST(ExcludedReadings, of_unknown_stations_are_errors_that_name_them) {
  try {
    read({{"X", "2020", 2}, {"A", "2020", 3}, {"Y", "", 4}}, {"2020"});
    FAIL();
  } catch (const Error& error) {
    ASSERT_EQ(error.messages().size(), 2u);
    EXPECT_EQ(error.messages()[0].sentence(), "f.csv:2: station 'X' is not in 'stations'");
  }
  const Outcome outcome = read({{"X", "2020", 2}, {"A", "2020", 3}}, {"2020"}, true);
  EXPECT_EQ(outcome.steps, (std::vector<std::vector<double>>{{-1, 2, 3}}));
  EXPECT_EQ(outcome.warnings.size(), 1u);
}

TEST(ReportingBesideExclusions, is_who_has_a_reading_that_is_not_excluded) {
  Warnings warnings;
  const ReadingsStations known(stations, {});
  const Exclusions excluded({"f.csv", {{"A", "1", 2}, {"A", "2", 3}, {"B", "1", 4}, {"C", "", 5}}},
                            known, false, warnings);
  ThreeGauges readings({"1", "2"});
  EXPECT_EQ(reporting_beside(excluded, ReportingStations{true, true, true}, readings),
            (ReportingStations{false, true, false}));
  EXPECT_EQ(without(excluded, ReportingStations{true, true, true}),
            (ReportingStations{true, true, false}));
}

}  // namespace
}  // namespace thiessen
