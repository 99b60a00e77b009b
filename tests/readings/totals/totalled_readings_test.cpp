#include "readings/totals/totalled_readings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/methods/method_study.h"

namespace thiessen {
namespace {

using namespace by_method;

struct Step {
  std::string time;
  std::vector<double> readings;
};
using Steps = std::vector<Step>;
using Texts = std::vector<std::string>;

/// Readings that are held, with lines from 2.
class Held : public Readings {
 public:
  explicit Held(Steps steps, std::string unit = "") : steps_(std::move(steps)), unit_(unit) {}
  bool next(TimeStep& step) override {
    if (done_ == steps_.size()) return false;
    step = {steps_[done_].time, steps_[done_].readings, done_ + 2};
    ++done_;
    return true;
  }
  std::string unit() const override { return unit_; }

 private:
  Steps steps_;
  std::string unit_;
  std::size_t done_ = 0;
};

/// Hours of one day from midnight, each with the same readings.
Steps hours(const std::string& day, const std::string& zone, const std::vector<int>& which,
            const std::vector<double>& readings) {
  Steps steps;
  for (const int hour : which) {
    const std::string clock = (hour < 10 ? "0" : "") + std::to_string(hour);
    steps.push_back({day + "T" + clock + ":00" + zone, readings});
  }
  return steps;
}

std::vector<int> from_to(int first, int last) {
  std::vector<int> all;
  for (int i = first; i <= last; ++i) all.push_back(i);
  return all;
}

Steps operator+(Steps a, const Steps& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// A gauge A of hours and a gauge B of totals, a kilometre apart.
struct Pair {
  by_method::Study study{{{"A", {0, 0}, 0}, {"B", {1, 0}, 0}},
                         {shapes::basin({{shapes::rectangle({0, 0}, {1, 1}), {}}})},
                         plane};
  ObservationHour hour;
  std::string unit_of_fine, unit_of_totals;
  bool has_days = false;
  Steps days;
  Warnings warnings;

  /// What B has in each step; an error instead where there is one.
  std::vector<double> b(const Steps& fine, const Steps& totals, std::string* fault = nullptr) {
    const TotalsSource source{"t.csv", [&](bool, Warnings&) {
                                std::vector<TotalsPart> parts(1);
                                parts[0].amounts = std::make_unique<Held>(totals, unit_of_totals);
                                if (has_days) parts[0].days = std::make_unique<Held>(days);
                                return parts;
                              }};
    TotalledReadings all(std::make_unique<Held>(fine, unit_of_fine), "r.csv", source, hour,
                         study.weighing, warnings);
    std::vector<double> found;
    try {
      std::size_t at = 0;
      for (TimeStep step; all.next(step); ++at) {
        EXPECT_EQ(step.time, fine[at].time);
        EXPECT_EQ(step.line, at + 2);
        found.push_back(step.readings[1]);
      }
      EXPECT_EQ(at, fine.size());
    } catch (const Error& error) {
      EXPECT_NE(fault, nullptr) << error.what();
      if (fault != nullptr) *fault = error.what();
    }
    return found;
  }
  std::string fault(const Steps& fine, const Steps& totals) {
    std::string text;
    b(fine, totals, &text);
    return text;
  }
  Texts told() const {
    Texts texts;
    for (const Message& message : warnings.messages()) texts.push_back(message.sentence());
    return texts;
  }
};

double sum(const std::vector<double>& amounts, std::size_t first, std::size_t count) {
  double all = 0;
  for (std::size_t i = first; i < first + count; ++i) all += amounts[i];
  return all;
}

constexpr int midnight = 24 * 60;

TEST(TotalledReadings, spread_a_day_over_23_hours_and_another_over_25) {
  Pair pair;
  pair.hour.minutes = midnight;
  const Steps spring = hours("2017-03-26", "+01:00", {0, 1}, {1, silent}) +
                       hours("2017-03-26", "+02:00", from_to(3, 23), {1, silent});
  const Steps autumn = hours("2017-10-29", "+02:00", {0, 1, 2}, {1, silent}) +
                       hours("2017-10-29", "+01:00", from_to(2, 23), {1, silent});
  EXPECT_EQ(pair.b(spring, {{"2017-03-26", {silent, 23}}}), std::vector<double>(23, 1));
  EXPECT_EQ(pair.b(autumn, {{"2017-10-29", {silent, 50}}}), std::vector<double>(25, 2));
}

TEST(TotalledReadings, spread_moments_with_a_zone_over_hours_of_another) {
  Pair pair;
  pair.hour.stamp = Stamp::end;
  const Steps fine = hours("2020-02-28", "Z", from_to(0, 23), {1, silent}) +
                     hours("2020-02-29", "Z", from_to(0, 23), {1, silent});
  // From 7:00 in Central Europe, which is 6:00 UTC, so that the hours that end at 7:00 to 6:00 UTC
  // are of it.
  const auto found = pair.b(
      fine, {{"2020-02-28T07:00+01:00", {silent, 5}}, {"2020-02-29T07:00+01:00", {silent, 48}}});
  EXPECT_TRUE(std::isnan(found[6]));
  for (std::size_t i = 7; i <= 24 + 6; ++i) EXPECT_EQ(found[i], 2) << i;
  EXPECT_TRUE(std::isnan(found[24 + 7]));
}

TEST(TotalledReadings, leave_out_periods_that_the_file_begins_or_ends_within) {
  Pair pair;
  pair.hour.minutes = 9 * 60;
  const Steps fine = hours("2020-01-01", "", from_to(0, 23), {1, silent}) +
                     hours("2020-01-02", "", from_to(0, 23), {1, silent});
  const auto found = pair.b(
      fine,
      {{"2020-01-01", {silent, 24}}, {"2020-01-02", {silent, 24}}, {"2020-01-03", {silent, 24}}});
  EXPECT_TRUE(std::isnan(found[8]));
  EXPECT_EQ(found[9], 1);
  EXPECT_EQ(found[24 + 8], 1);
  EXPECT_TRUE(std::isnan(found[24 + 9]));
  EXPECT_EQ(pair.told(),
            Texts{"t.csv:2: the total of station 'B' at '2020-01-01' is left out, for the steps of "
                  "'r.csv' do not cover the period, and so is 1 more"});
}

TEST(TotalledReadings, take_steps_that_the_file_lacks_for_steps_that_nobody_reported) {
  Pair pair;
  pair.hour.minutes = midnight;
  const Steps fine = hours("2020-01-01", "", {0, 1, 2, 3, 20, 23}, {1, silent}) +
                     hours("2020-01-02", "", {0, 1}, {1, silent});
  const auto found = pair.b(fine, {{"2020-01-01", {silent, 12}}});
  EXPECT_EQ(std::vector<double>(found.begin(), found.begin() + 6), std::vector<double>(6, 2));
}

TEST(TotalledReadings, spread_days_over_days_without_an_hour) {
  Pair pair;
  pair.has_days = true;
  pair.days = {{"2020-03-01", {silent, 3}}};
  const auto found = pair.b({{"2020-02-27", {1, 5}},
                             {"2020-02-28", {1, silent}},
                             {"2020-02-29", {2, silent}},
                             {"2020-03-01", {1, silent}}},
                            {{"2020-02-27", {silent, 7}}, {"2020-03-01", {silent, 8}}});
  EXPECT_EQ(found, (std::vector<double>{5, 2, 4, 2})) << "a leap day is one";
  EXPECT_EQ(pair.told(),
            Texts{"t.csv:2: the total of station 'B' at '2020-02-27' is passed over, for the gauge "
                  "reports in 'r.csv' within the period"});
}

TEST(TotalledReadings, refuse_what_cannot_be_known) {
  const Steps fine = hours("2020-01-01", "", from_to(0, 23), {1, silent});
  EXPECT_EQ(Pair().fault(fine, {{"2020-01-01", {silent, 1}}}),
            "t.csv:2: the total of '2020-01-01' has no hour, and nothing says when it was read");
  Pair six_hours;
  six_hours.hour = {7 * 60, true};
  EXPECT_EQ(six_hours.fault(hours("2020-01-01", "", {0, 6, 12, 18}, {1, silent}) +
                                hours("2020-01-02", "", {0, 6, 12, 18}, {1, silent}),
                            {{"2020-01-01", {silent, 1}}}),
            "t.csv:2: the total of '2020-01-01' ends at 2020-01-02T07:00, within the step "
            "'2020-01-02T06:00' of 'r.csv'");
  Pair overlapping;
  overlapping.hour.minutes = midnight;
  overlapping.has_days = true;
  overlapping.days = {{"2020-01-03", {silent, 2}}};
  EXPECT_EQ(overlapping.fault(fine, {{"2020-01-01", {silent, 1}},
                                     {"2020-01-02", {silent, 1}},
                                     {"2020-01-03", {silent, 1}}}),
            "t.csv:4: the total of station 'B' at '2020-01-03' begins before that at '2020-01-02' "
            "in line 3 ends");
  Pair zones;
  EXPECT_EQ(
      zones.fault(fine, {{"2020-01-01T00:00Z", {silent, 1}}, {"2020-01-02T00:00Z", {silent, 1}}}),
      "t.csv:2: time '2020-01-01T00:00Z' has a zone, and those of 'r.csv' have none");
  Pair order;
  order.hour.minutes = midnight;
  EXPECT_EQ(order.fault(hours("2020-01-01", "", {1, 0}, {1, silent}), {}),
            "r.csv:3: time '2020-01-01T00:00' comes after '2020-01-01T01:00', and totals are "
            "spread in the order of time");
  Pair rates;
  rates.unit_of_fine = "mm/h";
  EXPECT_EQ(rates.fault(fine, {}), "r.csv: its readings are rates in mm/h, and totals are depths");
  Pair labels;
  EXPECT_EQ(labels.fault({{"first", {1, silent}}}, {}),
            "r.csv:2: time 'first' is not one of the calendar, and totals are spread by the times "
            "of steps");
}

TEST(TotalledReadings, add_up_to_the_totals_whatever_was_reported) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(20); ++round) {
    Pair pair;
    const int at = static_cast<int>(60 * seeded.below(24));
    pair.hour = {at, seeded.below(2) == 0};
    Steps fine;
    Steps totals;
    for (int day = 1; day <= 9; ++day) {
      const std::string date = "2020-01-0" + std::to_string(day);
      fine = fine + hours(date, "", from_to(0, 23), {0, silent});
      totals.push_back({date, {silent, seeded.below(4) == 0 ? 0 : seeded.uniform(0, 50)}});
    }
    for (Step& step : fine) {
      const auto kind = seeded.below(4);
      step.readings[0] = kind == 0 ? silent : kind == 1 ? seeded.uniform(0, 9) : 0;
    }
    const auto found = pair.b(fine, totals);
    const std::size_t first = static_cast<std::size_t>(at / 60);
    for (std::size_t day = 1; day < 9; ++day) {
      // The total of this period, by the date at its end or its beginning.
      const double total = totals[pair.hour.is_dated_before ? day - 1 : day].readings[1];
      std::vector<double> amounts(
          found.begin() + static_cast<std::ptrdiff_t>(24 * (day - 1) + first),
          found.begin() + static_cast<std::ptrdiff_t>(24 * day + first));
      std::erase_if(amounts, [](double amount) { return std::isnan(amount); });
      EXPECT_NEAR(sum(amounts, 0, amounts.size()), total, 1e-12 * (total + 1));
    }
  }
}

}  // namespace
}  // namespace thiessen
