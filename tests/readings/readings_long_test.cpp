// Long tables, whichever way they are read, beside a table in memory.
#include "readings/readings_long.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "readings/long_tables.h"
#include "readings/readings_reader.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

using namespace long_tables;

std::vector<Step> steps_of(Readings& readings) {
  std::vector<Step> steps;
  for (TimeStep step; readings.next(step);) {
    steps.push_back({step.time, {step.readings.begin(), step.readings.end()}});
    for (double& reading : steps.back().readings) reading = std::isnan(reading) ? silent : reading;
  }
  return steps;
}

/// A table that can be read once, as a pipe.
class OnceTable : public Table {
 public:
  explicit OnceTable(const std::string& path) : csv_(path) {}
  const std::string& file() const override { return csv_.file(); }
  const std::vector<std::string>& header() const override { return csv_.header(); }
  bool next(Row& row) override { return csv_.next(row); }

 private:
  CsvReader csv_;
};

std::vector<Step> read(std::unique_ptr<Table> table, const std::vector<Station>& gauges) {
  Warnings warnings;
  return steps_of(*open_readings(std::move(table), gauges, {}, {}, warnings));
}

using Arrange = std::function<void(std::vector<TableRow>&, std::mt19937&)>;

void by_time(std::vector<TableRow>& rows, std::mt19937&) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const TableRow& a, const TableRow& b) { return a.time < b.time; });
}

void newest_first(std::vector<TableRow>& rows, std::mt19937&) {
  std::reverse(rows.begin(), rows.end());
}

void last_row_too_late(std::vector<TableRow>& rows, std::mt19937&) {
  if (!rows.empty()) std::rotate(rows.begin(), rows.begin() + 1, rows.end());
}

void with_one_row_elsewhere(std::vector<TableRow>& rows, std::mt19937& random) {
  if (!rows.empty()) std::swap(rows[random() % rows.size()], rows[random() % rows.size()]);
}

// In both orders of rows: by time, whose share is the file's, and by station, whose is the times'.
TEST(LongReadings, tell_the_line_of_a_time_and_how_much_is_read) {
  const TemporaryFolder folder;
  const std::vector<Station> gauges = stations(2);
  struct Order {
    std::string rows;
    std::vector<std::size_t> lines;
  };
  for (const Order& order : {Order{"1,S0,1\n1,S1,2\n2,S0,3\n2,S1,4\n3,S0,5\n", {2, 4, 6}},
                             Order{"1,S0,1\n2,S0,3\n3,S0,5\n1,S1,2\n2,S1,4\n", {2, 3, 4}}}) {
    const std::string path = folder.write("r.csv", "time,station,rain\n" + order.rows);
    Warnings warnings;
    const auto readings =
        open_readings(std::make_unique<CsvReader>(path), gauges, {}, {}, warnings);
    std::vector<std::size_t> lines;
    double before = 0;
    for (TimeStep step; readings->next(step);) {
      lines.push_back(step.line);
      EXPECT_GE(readings->share_read(), before);
      before = readings->share_read();
    }
    EXPECT_EQ(lines, order.lines);
    EXPECT_EQ(readings->share_read(), 1);
  }
}

TEST(LongReadings, are_the_same_in_any_order_of_rows_as_a_table_in_memory) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const std::vector<Arrange> orders = {
      [](auto&, auto&) {},   by_time, newest_first, by_station, shuffled, last_row_too_late,
      with_one_row_elsewhere};
  for (int round = 0; round < 20; ++round) {
    const std::size_t count = random() % 9 + 1;
    const std::vector<Station> gauges = stations(count);
    std::vector<TableRow> rows = random_rows(random, random() % 40, count);
    for (const Arrange& arrange : orders) {
      arrange(rows, random);
      const TemporaryFolder folder;
      const std::string path = folder.write("r.csv", text_of(rows));
      const std::vector<Step> expected = steps_in_memory(rows, count);
      ASSERT_EQ(read(std::make_unique<CsvReader>(path), gauges), expected) << text_of(rows);
      ASSERT_EQ(read(std::make_unique<OnceTable>(path), gauges), expected) << text_of(rows);
    }
  }
}

TEST(LongReadings, given_twice_a_million_times_are_the_first_twenty_by_line_and_a_count) {
  std::string text = "time,station,rain\n";
  for (int day = 0; day < 2; ++day) {  // not in the order of times: they are sorted
    for (int i = 0; i < 100'000; ++i) text += std::to_string(99'999 - i % 500) + ",S0,1\n";
  }
  const TemporaryFolder folder;
  const std::string path = folder.write("r.csv", text);
  const std::vector<Station> gauges = stations(1);
  try {
    read(std::make_unique<CsvReader>(path), gauges);
    FAIL() << "no Error was thrown";
  } catch (const Error& error) {
    ASSERT_EQ(error.messages().size(), 20u);
    EXPECT_EQ(error.unlisted(), 200'000u - 500 - 20);
    for (std::size_t i = 0; i < 20; ++i) {
      EXPECT_EQ(error.messages()[i].line, i + 502);
      EXPECT_EQ(error.messages()[i].text, "the reading of station 'S0' at '" +
                                              std::to_string(99'999 - i) + "' is already in line " +
                                              std::to_string(i + 2));
    }
  }
}

}  // namespace
}  // namespace thiessen
