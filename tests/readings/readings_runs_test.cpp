#include "readings/readings_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace thiessen {
namespace {

struct Piece {
  std::uint64_t first_line = 0;
  std::uint64_t line = 0;
  std::string time;
  std::vector<PieceReading> readings;

  ReadingsPiece view() const { return {first_line, line, time, readings}; }
};

void expect_same(const ReadingsPiece& found, const Piece& piece) {
  EXPECT_EQ(found.first_line, piece.first_line);
  EXPECT_EQ(found.line, piece.line);
  EXPECT_EQ(found.time, piece.time);
  ASSERT_EQ(found.readings.size(), piece.readings.size());
  for (std::size_t i = 0; i < piece.readings.size(); ++i) {
    const double amount = found.readings[i].amount;
    const double expected = piece.readings[i].amount;
    EXPECT_TRUE(amount == expected || (std::isnan(amount) && std::isnan(expected)));
    EXPECT_EQ(found.readings[i].station, piece.readings[i].station);
    EXPECT_EQ(found.readings[i].lines_on, piece.readings[i].lines_on);
  }
}

std::vector<Piece> random_pieces(std::mt19937& random, std::size_t count) {
  std::vector<Piece> pieces(count);
  for (Piece& piece : pieces) {
    piece.first_line = (std::uint64_t{random()} << 32U) + random();
    piece.line = piece.first_line + random() % 100;
    piece.time = std::string(random() % 30, 't');
    for (auto n = random() % 6; n > 0; --n) {
      const double amount = n == 3 ? std::nan("") : std::ldexp(random(), -20);
      piece.readings.push_back({amount, StationIndex{static_cast<std::uint32_t>(random())},
                                static_cast<std::uint32_t>(random())});
    }
  }
  return pieces;
}

std::string piece_bytes(const Piece& piece) {
  std::string bytes;
  append_piece(bytes, piece.view());
  EXPECT_EQ(bytes.size(), bytes_of(piece.view()));
  return bytes;
}

TEST(PieceBytes, begin_with_their_sizes_and_the_time) {
  const Piece piece = {7, 9, "2013-08", {{1.5, StationIndex{3}, 0}, {2, StationIndex{4}, 1}}};
  const std::string bytes = "before" + piece_bytes(piece);
  const PieceHead head = head_at(bytes.data() + 6);
  EXPECT_EQ(head.first_line, 7U);
  EXPECT_EQ(head.line, 9U);
  EXPECT_EQ(head.readings, 2U);
  EXPECT_EQ(head.readings_bytes(), 2 * sizeof(PieceReading));
  EXPECT_EQ(time_at(bytes.data() + 6), "2013-08");
}

TEST(PieceRuns, law_1_come_back_as_they_were_written_whatever_the_buffer) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::vector<std::vector<Piece>> written;
  PieceRuns runs;
  EXPECT_TRUE(runs.empty());
  for (const std::size_t count :
       {std::size_t{40}, std::size_t{0}, std::size_t{1}, std::size_t{100}}) {
    written.push_back(random_pieces(random, count));
    runs.begin();
    for (const Piece& piece : written.back()) runs.add(piece_bytes(piece));
  }
  runs.finish();
  ASSERT_EQ(runs.runs().size(), written.size());
  for (const std::size_t buffer : {std::size_t{1}, std::size_t{37}, std::size_t{1} << 20U}) {
    for (std::size_t r = 0; r < written.size(); ++r) {
      PieceRunReader reader(runs.file(), runs.runs()[r], buffer);
      std::vector<PieceReading> readings;
      for (const Piece& piece : written[r]) {
        ASSERT_TRUE(reader.next());
        EXPECT_EQ(reader.first_line(), piece.first_line);
        EXPECT_EQ(reader.time(), piece.time);
        expect_same(reader.take(readings), piece);
      }
      EXPECT_FALSE(reader.next());
    }
  }
}

TEST(PieceRuns, law_2_each_run_begins_where_the_one_before_ends) {
  PieceRuns runs;
  std::size_t bytes = 0;
  for (int i = 0; i < 3; ++i) {
    runs.begin();
    const std::string piece =
        piece_bytes(Piece{1, 1, std::string(static_cast<std::size_t>(i), 'x'), {}});
    runs.add(piece);
    runs.add(piece);
    EXPECT_EQ(runs.runs().back().begin, bytes);
    bytes += 2 * piece.size();
    EXPECT_EQ(runs.runs().back().end, bytes);
  }
}

TEST(PieceRunReader, tells_a_run_that_is_shorter_than_was_written) {
  PieceRuns runs;
  runs.begin();
  runs.add(piece_bytes(Piece{1, 1, "time", {{1, StationIndex{0}, 0}}}));
  runs.finish();
  PieceRuns::Run longer = runs.runs()[0];
  longer.end += 100;
  PieceRunReader reader(runs.file(), longer, 64);
  std::vector<PieceReading> readings;
  ASSERT_TRUE(reader.next());
  reader.take(readings);
  EXPECT_THROW(reader.next(), Error);
}

}  // namespace
}  // namespace thiessen
