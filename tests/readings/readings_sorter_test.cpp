#include "readings/readings_sorter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace thiessen {
namespace {

struct Piece {
  std::uint64_t first_line = 0;
  std::uint64_t line = 0;
  std::string time;
  std::vector<double> amounts;

  bool operator==(const Piece&) const = default;
};

void add(PieceSorter& sorter, const Piece& piece) {
  std::vector<PieceReading> readings;
  for (const double amount : piece.amounts) {
    readings.push_back({amount, StationIndex{7}, static_cast<std::uint32_t>(readings.size())});
  }
  sorter.add({piece.first_line, piece.line, piece.time, readings});
}

std::vector<Piece> all_of(PieceSorter& sorter) {
  std::vector<Piece> all;
  for (ReadingsPiece piece; sorter.next(piece);) {
    all.push_back({piece.first_line, piece.line, std::string(piece.time), {}});
    for (const PieceReading& reading : piece.readings) {
      EXPECT_EQ(reading.station, StationIndex{7});
      EXPECT_EQ(reading.lines_on, all.back().amounts.size());
      all.back().amounts.push_back(reading.amount);
    }
  }
  ReadingsPiece piece;
  EXPECT_FALSE(sorter.next(piece)) << "the end stays the end";
  return all;
}

std::vector<Piece> random_pieces(std::mt19937& random, std::size_t count, std::size_t times) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < count; ++i) {
    Piece piece = {random() % times + 1, i, std::string(random() % 20, 'x'), {}};
    piece.time += std::to_string(random() % times);
    for (auto n = random() % 5; n > 0; --n) piece.amounts.push_back(std::ldexp(random() % 999, -3));
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

TEST(PieceSorter, may_be_empty) {
  PieceSorter sorter(PieceSorter::Order::by_time, 100);
  EXPECT_TRUE(sorter.empty());
  EXPECT_EQ(all_of(sorter), std::vector<Piece>{});
}

TEST(PieceSorter, keeps_ties_as_they_came) {
  for (const std::size_t memory : {std::size_t{1}, std::size_t{100}, std::size_t{100'000}}) {
    PieceSorter sorter(PieceSorter::Order::by_first_line, memory);
    for (std::uint64_t i = 0; i < 100; ++i) add(sorter, {i % 3, i, "", {}});
    const std::vector<Piece> all = all_of(sorter);
    ASSERT_EQ(all.size(), 100u);
    for (std::size_t i = 1; i < all.size(); ++i) {
      EXPECT_TRUE(all[i - 1].first_line < all[i].first_line || all[i - 1].line < all[i].line);
    }
  }
}

TEST(PieceSorter, takes_pieces_that_are_larger_than_its_memory) {
  PieceSorter sorter(PieceSorter::Order::by_time, 64);
  const Piece large = {1, 1, std::string(100'000, 'b'), std::vector<double>(50'000, 2.5)};
  const Piece small = {2, 2, "a", {1}};
  add(sorter, large);
  add(sorter, small);
  EXPECT_EQ(all_of(sorter), (std::vector<Piece>{small, large}));
}

TEST(PieceSorter, is_the_same_as_a_stable_sort_whatever_its_memory) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int round = 0; round < 60; ++round) {
    std::vector<Piece> pieces = random_pieces(random, random() % 2000, random() % 500 + 1);
    const bool by_time = round % 2 == 0;
    const auto before = [&](const Piece& a, const Piece& b) {
      return by_time ? a.time < b.time : a.first_line < b.first_line;
    };
    if (round % 3 == 0) {  // stretches that ascend
      const auto middle = pieces.begin() + std::ssize(pieces) / 3;
      std::stable_sort(pieces.begin(), middle, before);
      std::stable_sort(middle, pieces.end(), before);
    }
    PieceSorter sorter(by_time ? PieceSorter::Order::by_time : PieceSorter::Order::by_first_line,
                       random() % 100'000);
    for (const Piece& piece : pieces) add(sorter, piece);
    std::stable_sort(pieces.begin(), pieces.end(), before);
    ASSERT_EQ(all_of(sorter), pieces);
  }
}

}  // namespace
}  // namespace thiessen
