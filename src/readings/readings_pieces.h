#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "rainfall/network.h"

namespace thiessen {

/// A reading of a station, and where it stands.
struct PieceReading {
  double amount = 0;  ///< NaN where silent
  StationIndex station = {};
  std::uint32_t lines_on = 0;  ///< counted from its piece's line
};

/// Readings of one time, in the file's order: all of them, or some where they are many or far
/// apart.
struct ReadingsPiece {
  std::uint64_t first_line = 0;  ///< on which the time first came, as far as is known
  std::uint64_t line = 0;        ///< from which the readings' lines count
  std::string_view time;
  std::span<const PieceReading> readings;
};

/// The readings of a table, piece by piece. Those of one time come together: their `first_line` is
/// the same, and no other time's is.
class ReadingsPieces {
 public:
  virtual ~ReadingsPieces() = default;
  /// Fills `piece`, whose views are valid until the next; false at the end. Throws Error.
  virtual bool next(ReadingsPiece& piece) = 0;
  /// How much of all is given, from 0 to 1; NaN where that is not known.
  virtual double share_given() const { return std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace thiessen
