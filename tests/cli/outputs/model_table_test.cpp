#include "cli/outputs/model_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "base/complaints.h"

namespace thiessen::cli {
namespace {

/// Keeps what it is given as text.
class Kept : public ModelSeries {
 public:
  explicit Kept(std::string& text) : text_(text) {}
  void add(const IsoTime& time, std::span<const double> rainfall,
           std::span<const double> errors) override {
    text_ += iso_text(time);
    for (const double value : rainfall)
      text_ += std::isnan(value) ? " -" : " " + std::to_string(value).substr(0, 3);
    if (!errors.empty()) text_ += " +-" + std::to_string(errors[0]).substr(0, 3);
    text_ += '\n';
  }
  void finish(Warnings& /*warnings*/) override { text_ += "end\n"; }

 private:
  std::string& text_;
};

RainStep step(const std::string& time, double rainfall) {
  RainStep step;
  step.time = time;
  step.line = 7;
  step.basins = {{rainfall, 2, 1, 0.5}};
  return step;
}

TEST(ModelTable, hands_on_steps_with_their_errors) {
  std::string text;
  Warnings told;
  ModelTable table(std::make_unique<Kept>(text), "hype", std::nullopt, "r.csv");
  table.add(step("2020-01-01T06:00", 1.5), 0);
  table.add(step("2020-01-02", std::numeric_limits<double>::quiet_NaN()), 0);
  table.finish(told);
  EXPECT_EQ(text, "2020-01-01T06:00 1.5 +-0.5\n2020-01-02 - +-0.5\nend\n");
}

TEST(ModelTable, refuses_a_time_that_is_none_with_its_line) {
  std::string text;
  ModelTable table(std::make_unique<Kept>(text), "hype", std::nullopt, "r.csv");
  EXPECT_TRUE(complaint_of([&] { table.add(step("week 1", 1), 0); })
                  .starts_with("r.csv:7: the time 'week 1' is none of the calendar, and --format "
                               "hype wants one"));
}

TEST(ModelTable, hands_on_totals_and_says_that_some_lack_steps) {
  std::string text;
  Warnings told;
  ModelTable table(std::make_unique<Kept>(text), "hype", Totalling{PeriodUnit::day, 3}, "r.csv");
  for (const char* time : {"2020-01-01T00:00", "2020-01-01T06:00", "2020-01-01T12:00",
                           "2020-01-01T18:00", "2020-01-02T00:00", "2020-01-02T12:00"})
    table.add(step(time, 1), 0);
  table.finish(told);
  EXPECT_EQ(text, "2020-01-01 4.0\n2020-01-02 2.0\nend\n");
  EXPECT_EQ(sentences_of(told).back(),
            "r.csv: 1 total lacks steps, and --format hype does not say which");
}

TEST(ModelTable, dates_periods_by_their_beginning) {
  const auto dates = [](const Every& every) {
    std::string text;
    Warnings told;
    ModelTable table(std::make_unique<Kept>(text), "netcdf", Totalling{every, 1'000}, "r.csv");
    table.add(step("2014-01-27T10:00", 1), 0);
    table.finish(told);
    return text.substr(0, text.find(' '));
  };
  Every every = PeriodUnit::week;
  EXPECT_EQ(dates(every), "2014-01-27");
  every.day_start = 32'400;
  EXPECT_EQ(dates(every), "2014-01-27T09:00");
  every = PeriodUnit::season;
  EXPECT_EQ(dates(every), "2013-12");
  every = PeriodUnit::year;
  every.year_start = 10;
  EXPECT_EQ(dates(every), "2013-10");
  every = PeriodUnit::hours;
  EXPECT_EQ(dates(every), "2014-01-27T10:00");
}

}  // namespace
}  // namespace thiessen::cli
