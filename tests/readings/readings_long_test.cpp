// Long tables, whichever way they are read, beside a table in memory.
#include "readings/readings_long.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "readings/readings_in_order.h"
#include "readings/readings_reader.h"
#include "readings/readings_scattered.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

constexpr double silent = -1;  // stands for NaN, which equals nothing, in what is compared

struct Row {
  std::string time;
  std::size_t station;
  double amount;
};

struct Step {
  std::string time;
  std::vector<double> readings;

  bool operator==(const Step&) const = default;
};

std::vector<Station> stations(std::size_t count) {
  std::vector<Station> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back({"S" + std::to_string(i), {}, i + 2});
  return all;
}

std::string text_of(const std::vector<Row>& rows) {
  std::string text = "time,station,rain\n";
  for (const Row& row : rows) {
    text += row.time + ",S" + std::to_string(row.station) + "," + std::to_string(row.amount) + "\n";
  }
  return text;
}

std::vector<Step> steps_in_memory(const std::vector<Row>& rows, std::size_t station_count) {
  std::vector<Step> steps;
  std::map<std::string, std::size_t> number_of;
  for (const Row& row : rows) {
    const auto [at, fresh] = number_of.emplace(row.time, steps.size());
    if (fresh) steps.push_back({row.time, std::vector<double>(station_count, silent)});
    steps[at->second].readings[row.station] = row.amount;
  }
  return steps;
}

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
  bool next(thiessen::Row& row) override { return csv_.next(row); }

 private:
  CsvReader csv_;
};

std::vector<Step> read(std::unique_ptr<Table> table, const std::vector<Station>& gauges) {
  Warnings warnings;
  return steps_of(*open_readings(std::move(table), gauges, {}, {}, warnings));
}

/// Rows of random times and stations, each pair once; `times` of them differ.
std::vector<Row> random_rows(std::mt19937& random, std::size_t times, std::size_t station_count) {
  std::vector<Row> rows;
  for (std::size_t t = 0; t < times; ++t) {
    for (std::size_t s = 0; s < station_count; ++s) {
      if (random() % 3 == 0) continue;
      rows.push_back({"t" + std::to_string(t), s, std::ldexp(random() % 100, -1)});
    }
  }
  return rows;
}

using Arrange = std::function<void(std::vector<Row>&, std::mt19937&)>;

void by_time(std::vector<Row>& rows, std::mt19937&) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.time < b.time; });
}

void newest_first(std::vector<Row>& rows, std::mt19937&) {
  std::reverse(rows.begin(), rows.end());
}

void by_station(std::vector<Row>& rows, std::mt19937&) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.station < b.station; });
}

void shuffled(std::vector<Row>& rows, std::mt19937& random) {
  std::shuffle(rows.begin(), rows.end(), random);
}

void last_row_too_late(std::vector<Row>& rows, std::mt19937&) {
  if (!rows.empty()) std::rotate(rows.begin(), rows.begin() + 1, rows.end());
}

void with_one_row_elsewhere(std::vector<Row>& rows, std::mt19937& random) {
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
    std::vector<Row> rows = random_rows(random, random() % 40, count);
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

ReadingsSource source_of(std::unique_ptr<Table> table, const std::vector<Station>& gauges,
                         Warnings& warnings) {
  auto known = std::make_unique<const ReadingsStations>(gauges, std::span<const std::string>());
  ReadingsFindings findings(table->file(), *known, false, warnings);
  return {std::move(table), std::move(known), ReadingGrammar({}, {}, DecimalMark::point),
          std::move(findings)};
}

/// Steps from pieces; the same time must not come in two places.
std::vector<Step> steps_of(ReadingsPieces& pieces, std::size_t station_count) {
  std::vector<Step> steps;
  std::uint64_t first_line = 0;
  std::set<std::uint64_t> first_lines;
  for (ReadingsPiece piece; pieces.next(piece);) {
    if (steps.empty() || piece.first_line != first_line) {
      first_line = piece.first_line;
      EXPECT_TRUE(first_lines.insert(first_line).second);
      steps.push_back({std::string(piece.time), std::vector<double>(station_count, silent)});
    }
    EXPECT_EQ(piece.time, steps.back().time);
    for (const PieceReading& reading : piece.readings) {
      double& amount = steps.back().readings[index(reading.station)];
      EXPECT_EQ(amount, silent);
      amount = reading.amount;
      EXPECT_GE(piece.line + reading.lines_on, first_line);
    }
  }
  return steps;
}

TEST(ScatteredPieces, come_in_the_order_of_times_whatever_the_memory) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const ReadingsLayout layout = {true, 0, 1, 2};
  for (int round = 0; round < 60; ++round) {
    const std::size_t count = random() % 9 + 1;
    const std::vector<Station> gauges = stations(count);
    std::vector<Row> rows = random_rows(random, random() % 200, count);
    (round % 2 == 0 ? shuffled : by_station)(rows, random);
    const TemporaryFolder folder;
    const std::string path = folder.write("r.csv", text_of(rows));
    Warnings warnings;
    LongRows table(source_of(std::make_unique<CsvReader>(path), gauges, warnings), layout);
    ScatteredPieces pieces(table, random() % 5000);
    ASSERT_EQ(steps_of(pieces, count), steps_in_memory(rows, count));
  }
}

TEST(InTimeOrder, is_said_of_tables_whose_times_do_not_come_back) {
  const TemporaryFolder folder;
  const auto in_order = [&](const std::string& rows) {
    CsvReader table(folder.write("r.csv", "time,station,rain\n" + rows));
    return is_in_time_order(table, 0);
  };
  EXPECT_TRUE(in_order(""));
  EXPECT_TRUE(in_order("1,A,1\n1,B,1\n9,A,1\n10,A,1\n"));
  EXPECT_TRUE(in_order("b,A,1\n ,A,1\nb,B,1\na,A,1\n")) << "an empty time is no time";
  EXPECT_FALSE(in_order("a,A,1\nb,A,1\na,B,1\n"));
  EXPECT_TRUE(in_order("a,A,1\nb\n\"c,A,1\n")) << "what cannot be read is met again";
}

TEST(OrderedPieces, notice_a_file_that_changes) {
  const TemporaryFolder folder;
  const std::string path = folder.write("r.csv", "time,station,rain\na,S0,1\nb,S0,1\na,S0,2\n");
  const std::vector<Station> gauges = stations(1);
  Warnings warnings;
  LongRows table(source_of(std::make_unique<CsvReader>(path), gauges, warnings), {true, 0, 1, 2});
  OrderedPieces pieces(table);
  ReadingsPiece piece;
  EXPECT_TRUE(pieces.next(piece));
  EXPECT_TRUE(pieces.next(piece));
  EXPECT_THROW(pieces.next(piece), Error);
}

TEST(OrderedPieces, of_a_time_with_many_rows_are_many) {
  std::string text = "time,station,rain\n";
  for (int i = 0; i < 200'000; ++i) text += "x,S0,1\n";
  const TemporaryFolder folder;
  const std::string path = folder.write("r.csv", text);
  const std::vector<Station> gauges = stations(1);
  Warnings warnings;
  LongRows table(source_of(std::make_unique<CsvReader>(path), gauges, warnings), {true, 0, 1, 2});
  OrderedPieces pieces(table);
  std::size_t readings = 0;
  for (ReadingsPiece piece; pieces.next(piece); readings += piece.readings.size()) {
    EXPECT_EQ(piece.first_line, 2u);
    EXPECT_EQ(piece.line, readings + 2);
    EXPECT_LT(piece.readings.size(), 100'000u);
  }
  EXPECT_EQ(readings, 200'000u);
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
