#include "readings/readings_long.h"

#include <limits>
#include <utility>

#include "base/utf8.h"
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
  while (has_piece_) {
    readings_.assign(readings_.size(), silent);
    lines_.assign(lines_.size(), no_line);
    step.time = piece_.time;
    step.line = piece_.first_line;
    const std::uint64_t first_line = piece_.first_line;
    do {
      take(piece_);
      has_piece_ = pieces_->next(piece_);
    } while (has_piece_ && piece_.first_line == first_line);
    ++steps_;
    step.readings = readings_;
    step.written = rows_.source().times.read(step.time, step.line);
    findings.note_format(step);
    findings.note_step(step);
    step.line = findings.line_of(step.line);
    if (findings.complaints().empty() && twice_.empty()) return true;
  }
  done_ = true;
  findings.complaints().add(twice_);
  findings.conclude(steps_);
  if (steps_ == 0) findings.warn("there is no time step");
  return false;
}

double LongReadings::share_read() const {
  return pieces_ ? pieces_->share_given() : std::numeric_limits<double>::quiet_NaN();
}

void LongReadings::begin() {
  done_ = true;  // if an exception comes, no step follows it
  const std::unique_ptr<Table> again = rows_.again();
  if (again && is_in_time_order(*again, rows_.time())) {
    pieces_ = std::make_unique<OrderedPieces>(rows_);
  } else {
    pieces_ = std::make_unique<ScatteredPieces>(rows_);
  }
  has_piece_ = pieces_->next(piece_);
  done_ = false;
}

void LongReadings::take(const ReadingsPiece& piece) {
  for (const PieceReading& reading : piece.readings) {
    const std::size_t line = piece.line + reading.lines_on;
    std::size_t& line_before = lines_[index(reading.station)];
    if (line_before != no_line) complain_of_twice(piece, reading, line);
    line_before = line;
    readings_[index(reading.station)] = reading.amount;
  }
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
