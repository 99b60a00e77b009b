// Steps of a pipe, as they come: wide ones with their row, long ones with a row of another step.
#include "readings/readings_fed.h"

#include <gtest/gtest.h>

#include "base/fed_pipe.h"
#include "readings/table_readings.h"

namespace thiessen {
namespace {

using std::chrono::milliseconds;
using table_readings::Texts;

/// Time within which a machine that is busy with other things hears a pipe.
constexpr milliseconds long_enough(20'000);

/// Readings of the stations A and B from a pipe.
class Feed {
 public:
  /// The pipe has to hold the header and a row at first.
  explicit Feed(const std::string& beginning)
      : stations_(table_readings::stations_called({"A", "B"})) {
    pipe_.feed(beginning);
    ReadingsOptions options;
    options.steps_as_they_come = true;
    CsvOptions csv;
    csv.finds_form = true;
    readings_ = open_readings(std::make_unique<CsvReader>(InputFile(pipe_.path()), csv), stations_,
                              {}, options, warnings_);
  }

  FedPipe& pipe() { return pipe_; }
  Readings& readings() { return *readings_; }
  const Warnings& warnings() const { return warnings_; }
  bool is_waiting(milliseconds patience = milliseconds(0)) {
    return readings_->is_waiting(patience);
  }
  /// The next step as "time: A B", where NaN is shown as a hyphen; "end" at the end.
  std::string next() {
    TimeStep step;
    if (!readings_->next(step)) return "end";
    std::string text = step.time + ":";
    for (const double reading : step.readings)
      text += " " + (std::isnan(reading) ? "-" : std::to_string(static_cast<int>(reading)));
    return text;
  }

 private:
  FedPipe pipe_;
  std::vector<Station> stations_;
  Warnings warnings_;
  std::unique_ptr<Readings> readings_;
};

TEST(FedReadings, has_a_wide_step_with_its_row) {
  Feed feed("time,A,B\n2020,1,2\n");
  EXPECT_FALSE(feed.is_waiting());
  EXPECT_EQ(feed.next(), "2020: 1 2");
  EXPECT_TRUE(feed.is_waiting());
  feed.pipe().feed("2021,3");
  EXPECT_TRUE(feed.is_waiting());
  feed.pipe().feed(",4\n2022,5,6\n");
  EXPECT_EQ(feed.next(), "2021: 3 4");
  EXPECT_EQ(feed.next(), "2022: 5 6");
  feed.pipe().feed("2023,7,");
  feed.pipe().end();
  EXPECT_FALSE(feed.is_waiting());
  EXPECT_EQ(feed.next(), "2023: 7 -");
  EXPECT_EQ(feed.next(), "end");
}

TEST(FedReadings, hears_all_ends_of_lines_and_passes_over_blank_ones) {
  Feed feed("time,A,B\r2020,1,2\r");
  EXPECT_EQ(feed.next(), "2020: 1 2");
  feed.pipe().feed("\n");
  EXPECT_TRUE(feed.is_waiting());
  feed.pipe().feed("\r\n \n2021,3,4\r\n");
  EXPECT_FALSE(feed.is_waiting());
  EXPECT_EQ(feed.next(), "2021: 3 4");
  feed.pipe().feed(",,\n");
  EXPECT_TRUE(feed.is_waiting());
  feed.pipe().feed("2022,5,6\r");
  EXPECT_FALSE(feed.is_waiting());
  EXPECT_EQ(feed.next(), "2022: 5 6");
  feed.pipe().end();
  EXPECT_EQ(feed.next(), "end");
}

TEST(FedReadings, tells_a_fault_though_the_pipe_does_not_end) {
  for (const std::string row : {"2021,x,4\n", "2021,3\n", ",3,4\n", "2020,3,4\n"}) {
    Feed feed("time,A,B\n2020,1,2\n" + row + "2022,5,6\n");
    EXPECT_EQ(feed.next(), "2020: 1 2");
    EXPECT_THROW(feed.next(), Error) << row;
  }
}

TEST(FedReadings, has_a_long_step_once_another_has_begun_and_the_pipe_rests) {
  Feed feed("time,station,rain\n2020,A,1\n");
  EXPECT_TRUE(feed.is_waiting(milliseconds(600)));
  feed.pipe().feed("2021,B,4\n");
  EXPECT_FALSE(feed.is_waiting(long_enough));
  EXPECT_EQ(feed.next(), "2020: 1 -");
  EXPECT_TRUE(feed.is_waiting(milliseconds(600)));
  feed.pipe().feed("2022,A,5\n2023,B,6\n");
  EXPECT_EQ(feed.next(), "2021: - 4");
  EXPECT_EQ(feed.next(), "2022: 5 -");
  EXPECT_TRUE(feed.is_waiting(milliseconds(600)));
  feed.pipe().end();
  EXPECT_EQ(feed.next(), "2023: - 6");
  EXPECT_EQ(feed.next(), "end");
}

TEST(FedReadings, has_a_long_step_once_each_station_has_a_row) {
  Feed feed("time,station,rain\n2020,A,1\n2020,B,\n");
  EXPECT_FALSE(feed.is_waiting(long_enough));
  EXPECT_EQ(feed.next(), "2020: 1 -");
  EXPECT_TRUE(feed.is_waiting(milliseconds(600)));
  feed.pipe().feed("2021,A,3\n2021,B,4\n2022,B,6\n");
  EXPECT_EQ(feed.next(), "2021: 3 4");
  EXPECT_TRUE(feed.is_waiting(milliseconds(600)));
  feed.pipe().feed("2022,A,5\n");
  EXPECT_EQ(feed.next(), "2022: 5 6");
  feed.pipe().feed("2022,A,5\n");
  EXPECT_THROW(feed.next(), Error);
}

// One station after the other, as a pipe from a file has them.
TEST(FedReadings, that_come_without_a_rest_are_sorted) {
  Feed feed("time,station,rain\n2020,A,1\n2021,A,3\n2020,B,2\n2021,B,4\n");
  feed.pipe().end();
  EXPECT_EQ(feed.next(), "2020: 1 2");
  EXPECT_EQ(feed.next(), "2021: 3 4");
  EXPECT_EQ(feed.next(), "end");
  EXPECT_TRUE(feed.warnings().messages().empty());
}

TEST(FedReadings, whose_times_come_back_before_the_first_rest_are_sorted_and_that_is_said) {
  Feed feed("time,station,rain\n2020,A,1\n2021,A,3\n2020,B,2\n");
  EXPECT_TRUE(feed.is_waiting(milliseconds(900)));
  ASSERT_EQ(feed.warnings().messages().size(), 1U);
  feed.pipe().feed("2021,B,4\n");
  feed.pipe().end();
  EXPECT_EQ(feed.next(), "2020: 1 2");
  EXPECT_EQ(feed.next(), "2021: 3 4");
  EXPECT_EQ(feed.next(), "end");
}

TEST(FedReadings, go_on_in_their_order_once_steps_were_given) {
  Feed feed("time,station,rain\n2020,A,1\n2021,A,3\n");
  EXPECT_EQ(feed.next(), "2020: 1 -");
  feed.pipe().feed("2020,B,2\n");
  try {
    feed.next();
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(
        std::string(error.what()).find(":4: time '2020' comes when its step, or one behind it"),
        std::string::npos)
        << error.what();
  }
}

TEST(FedReadings, of_a_long_table_tell_faults_though_the_pipe_does_not_end) {
  for (const std::string row : {"2021,A,x\n", "2021,A\n", ",A,1\n", "2020,A,1\n", "2020,C,1\n"}) {
    Feed feed("time,station,rain\n2020,A,1\n" + row + "2022,A,1\n");
    EXPECT_THROW(
        {
          while (feed.next() != "end") {
          }
        },
        Error)
        << row;
  }
}

}  // namespace
}  // namespace thiessen
