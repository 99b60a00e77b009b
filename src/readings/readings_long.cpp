#include "readings/readings_long.h"

#include <cmath>
#include <limits>
#include <utility>

#include "base/utf8.h"
#include "readings/readings_fed.h"
#include "readings/readings_in_order.h"
#include "readings/readings_scattered.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t no_line = 0;

}  // namespace

LongReadings::LongReadings(ReadingsSource source, const ReadingsLayout& layout)
    : rows_(std::move(source), layout),
      readings_(rows_.source().stations->all().size()),
      lines_(readings_.size()) {}

bool LongReadings::next(TimeStep& step) {
  if (done_) return false;
  if (!pieces_) begin();
  ReadingsFindings& findings = rows_.source().findings;
  while (has_piece()) {
    readings_.assign(readings_.size(), silent);
    lines_.assign(lines_.size(), no_line);
    step.time = piece_.time;
    step.line = piece_.first_line;
    const std::uint64_t first_line = piece_.first_line;
    do {
      take(piece_);
      wants_piece_ = true;
      // Of a pipe the next step may be long in coming.
      if (piece_.ends_step) break;
    } while (has_piece() && piece_.first_line == first_line);
    ++steps_;
    step.readings = readings_;
    step.written = rows_.source().times.read(step.time, step.line);
    findings.note_format(step);
    findings.note_step(step);
    step.line = findings.line_of(step.line);
    if (!is_faulty()) return true;
    if (rows_.source().steps_as_they_come) break;
  }
  done_ = true;
  findings.complaints().add(twice_);
  findings.conclude(steps_);
  if (steps_ == 0) findings.warn("there is no time step");
  return false;
}

bool LongReadings::is_waiting(std::chrono::milliseconds patience) {
  if (done_ || !rows_.source().steps_as_they_come) return false;
  if (!pieces_) begin();
  return wants_piece_ && !is_faulty() && pieces_->is_waiting(patience);
}

bool LongReadings::is_faulty() const {
  return !rows_.source().findings.complaints().empty() || !twice_.empty();
}

/// Whether there is a piece, which is read where that has not been done.
bool LongReadings::has_piece() {
  if (wants_piece_) has_piece_ = pieces_->next(piece_);
  wants_piece_ = false;
  return has_piece_;
}

double LongReadings::share_read() const {
  return pieces_ ? pieces_->share_given() : std::numeric_limits<double>::quiet_NaN();
}

void LongReadings::begin() {
  done_ = true;  // if an exception comes, no step follows it
  const std::unique_ptr<Table> again = rows_.again();
  if (again && is_in_time_order(*again, rows_.time())) {
    pieces_ = std::make_unique<OrderedPieces>(rows_);
  } else if (rows_.source().steps_as_they_come) {
    pieces_ = std::make_unique<FedPieces>(rows_);
  } else {
    pieces_ = std::make_unique<ScatteredPieces>(rows_);
  }
  done_ = false;
}

void LongReadings::take(const ReadingsPiece& piece) {
  for (const PieceReading& reading : piece.readings) {
    const std::size_t line = piece.line + reading.lines_on;
    std::size_t& line_before = lines_[index(reading.station)];
    if (line_before != no_line) {
      if (is_sent_again(reading)) continue;
      complain_of_twice(piece, reading, line);
    }
    line_before = line;
    readings_[index(reading.station)] = reading.amount;
  }
}

/// Whether a reading of the same step is what came before, in a pipe in which rows may come again.
bool LongReadings::is_sent_again(const PieceReading& reading) const {
  const double before = readings_[index(reading.station)];
  const bool is_same =
      before == reading.amount || (std::isnan(before) && std::isnan(reading.amount));
  return is_same && rows_.source().steps_may_come_again;
}

void LongReadings::complain_of_twice(const ReadingsPiece& piece, const PieceReading& reading,
                                     std::size_t line) {
  const ReadingsSource& source = rows_.source();
  twice_.add_by_line(
      source.findings.at(line,
                         "the reading of station " + quoted(source.stations->id(reading.station)) +
                             " at " + quoted(piece.time, 80) + " is already in " +
                             source.findings.in_words(lines_[index(reading.station)]),
                         ""));
}

}  // namespace thiessen
