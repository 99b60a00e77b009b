#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "rainfall/network/network.h"

namespace thiessen {

/// A reading of a station, and the line it stands in.
struct PieceReading {
  double amount = 0;  ///< NaN where silent
  StationIndex station = {};
  std::uint32_t lines_on = 0;  ///< counted from the line of its piece
};

/// Readings of one time, in the order of the file. A piece may hold only some of the time's
/// readings, where these are many or far apart.
struct ReadingsPiece {
  std::uint64_t first_line = 0;  ///< where the time first came, as far as is known
  std::uint64_t line = 0;        ///< the line from which those of the readings count
  std::string_view time;
  std::span<const PieceReading> readings;
  bool ends_step = false;  ///< no other piece of this time follows
};

/// The readings of a table, piece by piece. The pieces of one time follow each other and have the
/// same `first_line`, which no other time has.
class ReadingsPieces {
 public:
  virtual ~ReadingsPieces() = default;
  /// Reads the next piece into `piece`, whose views are valid until the next call; returns false at
  /// the end. Throws Error.
  virtual bool next(ReadingsPiece& piece) = 0;
  /// Whether the next piece has not come yet: see Readings::is_waiting.
  virtual bool is_waiting(std::chrono::milliseconds /*patience*/) { return false; }
  /// The share of all readings that has been given, from 0 to 1; NaN where that is not known.
  virtual double share_given() const { return std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace thiessen
