#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "base/patience.h"
#include "readings/readings_order.h"
#include "readings/readings_pieces.h"
#include "readings/readings_rows.h"
#include "readings/readings_scattered.h"

namespace thiessen {

/// The pieces of a long table that comes by a pipe whose end may be far, a step a piece.
///
/// A step is whole once each station has a row of it, or a row of another has come. Whole steps are
/// given as soon as the pipe rests (see Patience); so a pipe that brings a file without a rest,
/// such as one station after the other, is sorted as ScatteredPieces does, and so is one whose
/// times have come back before its first rest, which is told in a notice. Once steps have been
/// given, times go on in their order.
///
/// Law: a step that is given holds all readings of its time, or an Error follows. Where steps may
/// come again, rows of a step that has been given are passed over with a warning instead. Memory
/// then: some 100 bytes a step.
class FedPieces : public ReadingsPieces {
 public:
  /// `rows` must outlive this object.
  explicit FedPieces(LongRows& rows);

  /// Waits where there is no step to give. Throws Error where a time comes that does not go on in
  /// the order of those that were given.
  bool next(ReadingsPiece& piece) override;
  bool is_waiting(std::chrono::milliseconds patience) override;

 private:
  using Clock = std::chrono::steady_clock;

  /// A step that is whole, and the line from which those of its readings count.
  struct Step {
    std::size_t first_line = 0;
    std::string time;
    std::vector<PieceReading> readings;
  };

  bool is_last_whole() const { return reported_ == has_reported_.size(); }
  bool holds_steps() const {
    return times_gathered_ > 1 || (times_gathered_ > 0 && is_last_whole());
  }
  void note_station(const LongRow& row);
  bool take_rows();
  void take(const LongRow& row);
  bool is_given(const LongRow& row);
  void tell_late(const LongRow& row);
  bool rests();
  void release();
  bool take_released();
  void gather_again();

  LongRows& rows_;
  TimeOrder order_;
  std::string last_time_;
  bool has_order_ = true;  ///< no time has come back
  bool has_given_ = false;
  std::unordered_set<std::string> given_;  ///< the times of all steps, where they may come again
  bool told_late_ = false;                 ///< that rows are passed over
  std::vector<bool> has_reported_;         ///< at the last time, by station
  std::size_t reported_ = 0;
  bool has_told_ = false;  ///< that times have come back
  std::optional<ScatteredPieces> gathered_;
  std::size_t times_gathered_ = 0;  ///< the last of them may not be whole
  Patience patience_;               ///< with what may come behind the whole steps that are gathered
  Clock::time_point rests_since_;
  bool at_end_ = false;

  std::optional<ScatteredPieces> released_;
  bool is_last_released_ = false;
  ReadingsPiece piece_;  ///< of these, the first of the next step
  bool has_piece_ = false;
  Step step_;  ///< the next one to give
  bool has_step_ = false;
};

}  // namespace thiessen
