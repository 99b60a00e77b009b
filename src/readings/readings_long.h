#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "rainfall/series/readings.h"
#include "rainfall/series/stamp.h"
#include "readings/readings_pieces.h"
#include "readings/readings_rows.h"

namespace thiessen {

/// Reads a long table, which has a row for each time and station, in any order: see open_readings.
class LongReadings : public Readings {
 public:
  LongReadings(ReadingsSource source, const ReadingsLayout& layout);

  bool next(TimeStep& step) override;
  bool is_waiting(std::chrono::milliseconds patience) override;
  std::optional<Stamp> stamp() const override { return rows_.source().stamp; }
  double share_read() const override;

 private:
  void begin();
  bool has_piece();
  bool is_faulty() const;
  void take(const ReadingsPiece& piece);
  bool is_sent_again(const PieceReading& reading) const;
  void complain_of_twice(const ReadingsPiece& piece, const PieceReading& reading, std::size_t line);

  LongRows rows_;
  std::unique_ptr<ReadingsPieces> pieces_;
  ReadingsPiece piece_;  ///< the first piece of the next step
  bool has_piece_ = false;
  bool wants_piece_ = true;  ///< whether there is one has not been asked yet
  std::vector<double> readings_;
  std::vector<std::size_t>
      lines_;  ///< by station: the line of its last reading at this time; 0: none
  Complaints twice_;
  std::size_t steps_ = 0;
  bool done_ = false;
};

}  // namespace thiessen
