#include "readings/readings_fed.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/interrupt.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::chrono::milliseconds at_once(0);
constexpr std::chrono::milliseconds longest_wait(200);
/// Rows are taken for so long before it is looked whether a step is to be given.
constexpr std::chrono::milliseconds longest_taking(50);
constexpr std::size_t rows_between_looks = 256;

}  // namespace

FedPieces::FedPieces(LongRows& rows)
    : rows_(rows), has_reported_(rows.source().stations->all().size()) {}

bool FedPieces::next(ReadingsPiece& piece) {
  while (is_waiting(longest_wait)) throw_if_interrupted();
  if (at_end_) return released_ && released_->next(piece);
  has_step_ = false;
  piece = {step_.first_line, step_.first_line, step_.time, step_.readings, true};
  return true;
}

bool FedPieces::is_waiting(std::chrono::milliseconds patience) {
  const auto until = Clock::now() + patience;
  for (;;) {
    if (has_step_ || at_end_ || take_released()) return false;
    const auto now = Clock::now();
    if (!take_rows()) {
      if (!at_end_ && now >= until) return true;
      continue;
    }
    if (rests()) continue;
    if (rows_.source().gives_up()) {
      at_end_ = true;
      return false;
    }
    if (now >= until) return true;
    // While steps are held back the pipe may not be waited for longer than these.
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - now);
    rows_.source().is_waiting(holds_steps() ? std::min(left, patience_.left()) : left);
  }
}

/// Takes the rows that are there, for a while. Returns whether there is none left.
bool FedPieces::take_rows() {
  const auto begin = Clock::now();
  LongRow row;
  for (std::size_t count = 1; !rows_.source().is_waiting(at_once); ++count) {
    if (count % rows_between_looks == 0 && Clock::now() - begin > longest_taking) return false;
    if (at_end_ || !rows_.next(row)) {
      at_end_ = true;
      release();
      return false;
    }
    take(row);
    rests_since_ = Clock::now();
  }
  return true;
}

void FedPieces::take(const LongRow& row) {
  if (is_given(row)) return tell_late(row);
  if (times_gathered_ == 0 || row.time != last_time_) {
    if (!order_.follows(row.time)) has_order_ = false;
    if (!has_order_ && has_given_) {
      rows_.source().findings.complaints().add(
          {rows_.source().findings.file(), row.line,
           "time " + quoted(row.time, 80) +
               " comes when its step, or one behind it, has been written",
           "the rows of a pipe stand in the order of their times; a file is sorted"});
      at_end_ = true;
      return;
    }
    last_time_ = row.time;
    ++times_gathered_;
    has_reported_.assign(has_reported_.size(), false);
    reported_ = 0;
  }
  note_station(row);
  if (!gathered_) gathered_.emplace();
  gathered_->add(row);
}

/// Whether the row is of a step that has been given, which may come again.
bool FedPieces::is_given(const LongRow& row) {
  if (given_.empty()) return false;
  const bool goes_on = times_gathered_ > 0 && row.time == last_time_;
  return !goes_on && given_.contains(std::string(row.time));
}

/// Says that rows are passed over whose step has been given: once, as the pipe may have no end.
void FedPieces::tell_late(const LongRow& row) {
  if (std::exchange(told_late_, true)) return;
  ReadingsFindings& findings = rows_.source().findings;
  const std::string station =
      row.has_station ? "of station " + quoted(rows_.source().stations->id(row.station)) + " " : "";
  findings.warn(findings.in_words(row.line) + ": the reading " + station + "at " +
                quoted(row.time, 80) +
                " comes when its step has been written, and is passed over, as are all that do");
}

void FedPieces::note_station(const LongRow& row) {
  if (!row.has_station || has_reported_[index(row.station)]) return;
  has_reported_[index(row.station)] = true;
  ++reported_;
}

/// Called where no row is there. Returns whether steps have been released.
bool FedPieces::rests() {
  if (!holds_steps()) return false;
  if (Clock::now() - rests_since_ < patience_.left()) return false;
  if (has_order_) {
    release();
    return true;
  }
  if (!std::exchange(has_told_, true)) {
    rows_.source().findings.warn(
        "its times come back, so that its steps are sorted, and written when the pipe ends");
  }
  return false;
}

/// Lets all steps that are gathered be given.
void FedPieces::release() {
  patience_.renew();
  released_ = std::exchange(gathered_, std::nullopt);
  is_last_released_ = is_last_whole();
  times_gathered_ = 0;
  if (!released_) return;
  released_->end_rows();
  if (!at_end_) has_piece_ = released_->next(piece_);
}

/// Takes the next step of those released. A last one that may not be whole goes back to what is
/// gathered.
bool FedPieces::take_released() {
  if (!has_piece_) return false;
  step_.first_line = piece_.first_line;
  step_.time = piece_.time;
  step_.readings.clear();
  do {
    for (PieceReading reading : piece_.readings) {
      const std::size_t line = piece_.line + reading.lines_on;
      reading.lines_on = static_cast<std::uint32_t>(line - step_.first_line);
      step_.readings.push_back(reading);
    }
    has_piece_ = released_->next(piece_);
  } while (has_piece_ && piece_.first_line == step_.first_line);
  if (has_piece_ || is_last_released_) {
    if (rows_.source().steps_may_come_again) given_.insert(step_.time);
    return has_step_ = has_given_ = true;
  }
  gather_again();
  return false;
}

void FedPieces::gather_again() {
  released_.reset();
  gathered_.emplace();
  times_gathered_ = 1;
  gathered_->add({step_.first_line, step_.time, false, {}, 0});
  for (const PieceReading& reading : step_.readings) {
    gathered_->add(
        {step_.first_line + reading.lines_on, step_.time, true, reading.station, reading.amount});
  }
}

}  // namespace thiessen
