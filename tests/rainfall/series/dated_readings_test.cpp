#include "rainfall/series/dated_readings.h"

#include <gtest/gtest.h>

#include "rainfall/series/readings_of.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

StepTimes within(std::string_view from, std::string_view to) {
  return {{parse_iso_time(from).time, parse_iso_time(to).time}, TimePrecision::year};
}

struct Outcome {
  Texts times;
  std::vector<double> readings;
  Texts sentences;
  Texts hints;
  Texts warnings;
  std::size_t unlisted = 0;
};

Outcome read(std::unique_ptr<Readings> all, const StepTimes& wanted) {
  Outcome outcome;
  Warnings warnings;
  DatedReadings readings(std::move(all), "r.csv", wanted, warnings);
  try {
    for (TimeStep step; readings.next(step);) {
      outcome.times.push_back(step.time);
      outcome.readings.push_back(step.readings[0]);
    }
  } catch (const Error& error) {
    for (const Message& message : error.messages()) {
      outcome.sentences.push_back(message.sentence());
      outcome.hints.push_back(message.hint.plain());
    }
    outcome.unlisted = error.unlisted();
  }
  for (const Message& message : warnings.messages()) outcome.warnings.push_back(message.sentence());
  return outcome;
}

Outcome read(const Texts& times, const StepTimes& wanted) {
  return read(std::make_unique<ReadingsOf>(times), wanted);
}

TEST(DatedReadings, are_the_steps_in_the_range) {
  const Outcome outcome = read({"2013-07-31", "2013-08-01", "20130831T2300", "2013-09-01"},
                               within("2013-08", "2013-08"));
  EXPECT_EQ(outcome.times, (Texts{"2013-08-01", "20130831T2300"}));
  EXPECT_EQ(outcome.readings, (std::vector<double>{1, 2}));
  EXPECT_EQ(outcome.warnings, Texts{});
}

TEST(DatedReadings, may_come_in_any_order) {
  const Texts times = {"2013-09-01", "2013-08-02", "2012", "2013-08-01"};
  EXPECT_EQ(read(times, within("2013-08", "2013-08")).times, (Texts{"2013-08-02", "2013-08-01"}));
}

TEST(DatedReadings, may_have_blanks_around_their_times) {
  EXPECT_EQ(read({" 2013-08-01\t"}, {}).times, (Texts{" 2013-08-01\t"}));
}

TEST(DatedReadings, report_every_wrong_time_at_the_end) {
  const Outcome outcome = read({"2013-08-01", "storm", "2013-08-02", "2013-02-30"}, {});
  EXPECT_EQ(outcome.times, (Texts{"2013-08-01"}));
  EXPECT_EQ(outcome.sentences, (Texts{"r.csv:3: time 'storm' is not written as ISO 8601 wants it",
                                      "r.csv:5: time '2013-02-30' does not exist"}));
  EXPECT_EQ(outcome.hints.at(0),
            "wanted: 2013, 2013-08, 2013-08-31, 2013-08-31T06:00 or 20130831T0600; 'time_format' "
            "says how else, such as '%d/%m/%Y %H:%M'");
}

TEST(DatedReadings, report_wrong_times_outside_the_range_too) {
  EXPECT_EQ(read({"2013-08-01", "8/2013"}, within("2013", "2013")).sentences.size(), 1u);
}

TEST(DatedReadings, list_twenty_wrong_times_and_count_the_rest) {
  const Outcome outcome = read(Texts(1000, "2013-02-30"), {});
  EXPECT_EQ(outcome.sentences.size(), 20u);
  EXPECT_EQ(outcome.unlisted, 980u);
}

TEST(DatedReadings, say_once_that_times_are_written_otherwise) {
  const Outcome outcome = read(Texts(1000, "storm"), {});
  EXPECT_EQ(outcome.sentences.size(), 1u);
  EXPECT_EQ(outcome.unlisted, 0u);
}

TEST(DatedReadings, report_what_else_is_wrong_in_the_order_of_the_lines) {
  const Outcome outcome = read(std::make_unique<ReadingsOf>(Texts{"2013", "2013-13", "2013-14"},
                                                            Message{"r.csv", 3, "bad", ""}),
                               {});
  EXPECT_EQ(outcome.sentences, (Texts{"r.csv:3: time '2013-13' does not exist", "r.csv:3: bad",
                                      "r.csv:4: time '2013-14' does not exist"}));
}

TEST(DatedReadings, say_at_least_what_is_asked_for) {
  EXPECT_EQ(read({"2013-08"}, {{}, TimePrecision::month}).sentences, Texts{});
  EXPECT_EQ(read({"2013-08"}, {{}, TimePrecision::day}).sentences,
            Texts{"r.csv:2: time '2013-08' does not say the day"});
  EXPECT_EQ(read({"2013"}, {{}, TimePrecision::month}).sentences,
            Texts{"r.csv:2: time '2013' does not say the month"});
}

TEST(DatedReadings, warn_where_none_is_in_the_range) {
  EXPECT_EQ(
      read({"2012-01", "2012-02", "2012-03"}, within("2013", "2013")).warnings,
      Texts{"r.csv: no time step is in the range: the first is '2012-01', the last '2012-03'"});
  EXPECT_EQ(read(Texts{}, within("2013", "2013")).warnings, Texts{});
}

/// A pipe that brings one step and then waits.
class OneStep : public ReadingsOf {
 public:
  explicit OneStep(const std::string& time) : ReadingsOf({time}) {}
  bool next(TimeStep& step) override {
    EXPECT_FALSE(given_) << "this would wait";
    given_ = true;
    return ReadingsOf::next(step);
  }
  bool is_waiting(std::chrono::milliseconds) override { return given_; }

 private:
  bool given_ = false;
};

TEST(DatedReadings, of_a_pipe_wait_for_a_step_in_the_range) {
  Warnings warnings;
  DatedReadings before(std::make_unique<OneStep>("2012"), "r.csv", within("2013", "2013"),
                       warnings);
  EXPECT_TRUE(before.is_waiting(std::chrono::milliseconds(0)));
  DatedReadings in_it(std::make_unique<OneStep>("2013"), "r.csv", within("2013", "2013"), warnings);
  EXPECT_FALSE(in_it.is_waiting(std::chrono::milliseconds(0)));
  TimeStep step;
  ASSERT_TRUE(in_it.next(step));
  EXPECT_EQ(step.time, "2013");
  EXPECT_TRUE(in_it.is_waiting(std::chrono::milliseconds(0)));
}

}  // namespace
}  // namespace thiessen
