#include "readings/readings_scattered.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "readings/long_tables.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

using namespace long_tables;

LongRow row_at(std::size_t line, const char* time, std::uint32_t station, double amount) {
  return {line, time, true, StationIndex{station}, amount};
}

TEST(ReadingsPart, chains_the_readings_of_each_time_in_the_order_in_which_they_came) {
  ReadingsPart part;
  EXPECT_TRUE(part.empty());
  part.add(row_at(10, "b", 0, 1));
  part.add(row_at(11, "a", 0, 2));
  part.add(row_at(15, "b", 3, 4));
  LongRow unknown = row_at(16, "c", 0, 8);
  unknown.has_station = false;
  part.add(unknown);
  ASSERT_EQ(part.times(), 3U);
  const ReadingsPiece first = part.piece(0);
  EXPECT_EQ(first.time, "b");
  EXPECT_EQ(first.first_line, 10U);
  EXPECT_EQ(first.line, 10U);
  ASSERT_EQ(first.readings.size(), 2U);
  EXPECT_EQ(first.readings[1].amount, 4);
  EXPECT_EQ(first.readings[1].station, StationIndex{3});
  EXPECT_EQ(first.readings[1].lines_on, 5U);
  EXPECT_EQ(part.piece(1).readings.size(), 1U);
  EXPECT_EQ(part.piece(2).readings.size(), 0U) << "a time without a station of the study is a time";
  EXPECT_EQ(part.piece(2).first_line, 16U);
}

TEST(ReadingsPart, takes_rows_whose_lines_are_within_32_bits_of_its_first) {
  ReadingsPart part;
  EXPECT_TRUE(part.can_take(row_at(std::size_t{1} << 40U, "a", 0, 1)));
  part.add(row_at(5, "a", 0, 1));
  EXPECT_TRUE(part.can_take(row_at(5 + 0xFFFFFFFFULL, "a", 0, 1)));
  EXPECT_FALSE(part.can_take(row_at(6 + 0xFFFFFFFFULL, "a", 0, 1)));
}

TEST(ScatteredPieces, come_in_the_order_of_times_whatever_the_memory) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int round = 0; round < 60; ++round) {
    const std::size_t count = random() % 9 + 1;
    const std::vector<Station> gauges = stations(count);
    std::vector<TableRow> rows = random_rows(random, random() % 200, count);
    (round % 2 == 0 ? shuffled : by_station)(rows, random);
    const TemporaryFolder folder;
    const std::string path = folder.write("r.csv", text_of(rows));
    Warnings warnings;
    LongRows table(source_of(std::make_unique<CsvReader>(path), gauges, warnings), layout);
    ScatteredPieces pieces(table, random() % 5000);
    ASSERT_EQ(steps_of(pieces, count), steps_in_memory(rows, count));
    EXPECT_EQ(pieces.share_given(), 1);
  }
}

}  // namespace
}  // namespace thiessen
