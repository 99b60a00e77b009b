#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "readings/readings_pieces.h"
#include "readings/readings_runs.h"

namespace thiessen {

/// Sorts any number of pieces of readings in bounded memory, by merging sorted runs of them from a
/// temporary file. Pieces that tie come in the order in which they were added.
///
/// Cost: n log n comparisons at most, and few where the pieces come in a few long stretches that
/// are sorted already.
class PieceSorter : public ReadingsPieces {
 public:
  enum class Order : std::uint8_t { by_time, by_first_line };

  /// `memory` bounds the bytes of pieces that are held while they are added, and those of the runs'
  /// buffers afterwards.
  PieceSorter(Order order, std::size_t memory) : order_(order), memory_(memory) {}

  /// Adds a piece. Requires that `next` has not been called.
  void add(const ReadingsPiece& piece);
  bool empty() const { return runs_.empty() && starts_.empty(); }
  bool next(ReadingsPiece& piece) override;

 private:
  bool comes_before(std::size_t a, std::size_t b) const;
  bool is_later(std::size_t a, std::size_t b) const;
  void sort();
  void spill();
  void begin_reading();
  void begin_merge();
  bool next_merged(ReadingsPiece& piece);

  Order order_;
  std::size_t memory_;
  std::string bytes_;                ///< the bytes of the pieces held
  std::vector<std::size_t> starts_;  ///< where each piece begins in them
  std::size_t given_ = 0;
  PieceRuns runs_;
  std::vector<PieceRunReader> readers_;
  std::vector<std::size_t> heap_;  ///< numbers of readers; the one with the next piece first
  std::vector<PieceReading> readings_;
  std::optional<std::size_t> taken_from_;  ///< the reader of the piece given last
  bool reading_ = false;
};

}  // namespace thiessen
