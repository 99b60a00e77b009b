#include "readings/readings_in_order.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "readings/long_tables.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

using namespace long_tables;

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

/// The pieces of a table of one gauge, S0.
struct OfOneGauge {
  explicit OfOneGauge(const std::string& rows)
      : path(folder.write("r.csv", "time,station,rain\n" + rows)),
        table(source_of(std::make_unique<CsvReader>(path), gauges, warnings), layout),
        pieces(table) {}

  TemporaryFolder folder;
  std::string path;
  std::vector<Station> gauges = stations(1);
  Warnings warnings;
  LongRows table;
  OrderedPieces pieces;
};

TEST(OrderedPieces, are_one_a_time_in_the_order_of_the_file) {
  OfOneGauge of("b,S0,1\nb,S0,2\n\na,S0,3\n");
  ReadingsPiece piece;
  ASSERT_TRUE(of.pieces.next(piece));
  EXPECT_EQ(piece.time, "b");
  EXPECT_EQ(piece.first_line, 2U);
  ASSERT_EQ(piece.readings.size(), 2U);
  EXPECT_EQ(piece.readings[1].amount, 2);
  EXPECT_EQ(piece.readings[1].lines_on, 1U);
  ASSERT_TRUE(of.pieces.next(piece));
  EXPECT_EQ(piece.time, "a");
  EXPECT_EQ(piece.first_line, 5U);
  EXPECT_FALSE(of.pieces.next(piece));
  EXPECT_FALSE(of.pieces.next(piece)) << "the end stays the end";
  EXPECT_EQ(of.pieces.share_given(), 1);
}

TEST(OrderedPieces, notice_a_file_that_changes) {
  OfOneGauge of("a,S0,1\nb,S0,1\na,S0,2\n");
  ReadingsPiece piece;
  EXPECT_TRUE(of.pieces.next(piece));
  EXPECT_TRUE(of.pieces.next(piece));
  EXPECT_THROW(of.pieces.next(piece), Error);
}

TEST(OrderedPieces, of_a_time_with_many_rows_are_many) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += "x,S0,1\n";
  OfOneGauge of(text);
  std::size_t readings = 0;
  for (ReadingsPiece piece; of.pieces.next(piece); readings += piece.readings.size()) {
    EXPECT_EQ(piece.first_line, 2u);
    EXPECT_EQ(piece.line, readings + 2);
    EXPECT_LT(piece.readings.size(), 100'000u);
  }
  EXPECT_EQ(readings, 200'000u);
}

}  // namespace
}  // namespace thiessen
