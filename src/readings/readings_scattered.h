#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "readings/readings_pieces.h"
#include "readings/readings_rows.h"
#include "readings/readings_sorter.h"
#include "readings/readings_times.h"

namespace thiessen {

/// The readings of one part of a long table; those of one time are chained through the part.
class ReadingsPart {
 public:
  bool empty() const { return times_.size() == 0; }
  /// Whether the row's line is near enough to the first one for its distance to fit in 32 bits.
  bool can_take(const LongRow& row) const;
  void add(const LongRow& row);
  std::size_t bytes() const;
  std::size_t times() const { return times_.size(); }
  /// The readings of the time that came as number `step`, from 0. Valid until the next call.
  ReadingsPiece piece(std::size_t step);

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  struct Chain {
    std::uint32_t first = none;
    std::uint32_t last = none;
  };

  std::size_t line_ = 0;
  ReadingsTimes times_;
  std::vector<Chain> chains_;  ///< by time
  std::vector<PieceReading> readings_;
  std::vector<std::uint32_t> next_;  ///< by reading: the next one of the same time
  std::vector<PieceReading> gathered_;
};

/// The pieces of a long table whose rows come in any order; they are given in the order in which
/// the times first came. All rows are added, or read, first.
///
/// What does not fit in `memory` bytes waits in temporary files (see spool.h), some 20 bytes a
/// reading. It is sorted part by part by time and merged; then it is sorted in the same way by the
/// line on which each time first came.
class ScatteredPieces : public ReadingsPieces {
 public:
  static constexpr std::size_t usual_memory = std::size_t{32} << 20;

  explicit ScatteredPieces(std::size_t memory = usual_memory);
  /// Adds all rows that there are.
  explicit ScatteredPieces(LongRows& rows, std::size_t memory = usual_memory);

  void add(const LongRow& row);
  /// Has to be called behind the last row, and before `next`.
  void end_rows();
  bool next(ReadingsPiece& piece) override;
  double share_given() const override;

 private:
  void flush();
  void sort_by_first_line();

  std::size_t memory_;
  ReadingsPart part_;
  std::size_t times_ = 0;
  std::size_t given_ = 0;         ///< times that have been given
  std::uint64_t last_given_ = 0;  ///< first line of the last one; no line has the number 0
  PieceSorter by_time_;
  PieceSorter by_first_line_;
};

}  // namespace thiessen
