#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "readings/readings_order.h"
#include "readings/readings_pieces.h"
#include "readings/readings_rows.h"
#include "readings/times/time_columns.h"

namespace thiessen {

/// Whether the rows of each time stand together and no time comes back, as far as TimeOrder can
/// tell. Reads the whole table, or up to the row where this does not hold. Rows that cannot be read
/// are not reported here.
bool is_in_time_order(Table& table, TimeColumns times);

/// The pieces of a long table for which is_in_time_order is true, read one time after the other.
class OrderedPieces : public ReadingsPieces {
 public:
  /// `rows` must outlive this object.
  explicit OrderedPieces(LongRows& rows) : rows_(rows) {}

  /// Gives the pieces in the order of the file. Throws Error if a time comes back after all, for
  /// then the file changes while it is read.
  bool next(ReadingsPiece& piece) override;
  double share_given() const override { return rows_.source().table->share_read(); }

 private:
  LongRows& rows_;
  LongRow row_;
  bool has_row_ = false;
  bool at_end_ = false;
  TimeOrder order_;
  std::string time_;
  std::size_t first_line_ = 0;
  std::vector<PieceReading> readings_;
};

}  // namespace thiessen
