#include "readings/readings_scattered.h"

#include <limits>

namespace thiessen {

bool ReadingsPart::can_take(const LongRow& row) const {
  return empty() || row.line - line_ <= std::numeric_limits<std::uint32_t>::max();
}

void ReadingsPart::add(const LongRow& row) {
  if (empty()) line_ = row.line;
  const ReadingsTimes::Entered entered = times_.enter(row.time, row.line);
  if (entered.fresh) chains_.push_back({});
  if (!row.has_station) return;
  const auto number = static_cast<std::uint32_t>(readings_.size());
  Chain& chain = chains_[entered.step];
  if (chain.first == none) {
    chain.first = number;
  } else {
    next_[chain.last] = number;
  }
  chain.last = number;
  readings_.push_back({row.amount, row.station, static_cast<std::uint32_t>(row.line - line_)});
  next_.push_back(none);
}

std::size_t ReadingsPart::bytes() const {
  return times_.bytes() + chains_.size() * sizeof(Chain) +
         readings_.size() * (sizeof(PieceReading) + sizeof(std::uint32_t));
}

ReadingsPiece ReadingsPart::piece(std::size_t step) {
  gathered_.clear();
  for (std::uint32_t i = chains_[step].first; i != none; i = next_[i]) {
    gathered_.push_back(readings_[i]);
  }
  return {times_.line(step), line_, times_.text(step), gathered_};
}

ScatteredPieces::ScatteredPieces(std::size_t memory)
    : memory_(memory),
      by_time_(PieceSorter::Order::by_time, memory),
      by_first_line_(PieceSorter::Order::by_first_line, memory) {}

ScatteredPieces::ScatteredPieces(LongRows& rows, std::size_t memory) : ScatteredPieces(memory) {
  for (LongRow row; rows.next(row);) add(row);
  end_rows();
}

void ScatteredPieces::add(const LongRow& row) {
  if (part_.bytes() > memory_ || !part_.can_take(row)) flush();
  part_.add(row);
}

void ScatteredPieces::end_rows() {
  times_ = part_.times();
  if (by_time_.empty()) return;
  flush();
  times_ = 0;
  sort_by_first_line();
}

void ScatteredPieces::flush() {
  for (std::size_t step = 0; step < part_.times(); ++step) by_time_.add(part_.piece(step));
  part_ = ReadingsPart();
}

void ScatteredPieces::sort_by_first_line() {
  ReadingsPiece piece;
  std::string time;
  std::uint64_t first_line = 0;  // no line has this number
  while (by_time_.next(piece)) {
    if (first_line == 0 || piece.time != time) {
      time = piece.time;
      first_line = piece.first_line;
      ++times_;
    }
    piece.first_line = first_line;
    by_first_line_.add(piece);
  }
  by_time_ = PieceSorter(PieceSorter::Order::by_time, memory_);
}

bool ScatteredPieces::next(ReadingsPiece& piece) {
  if (given_ < part_.times()) {
    piece = part_.piece(given_++);
    return true;
  }
  if (!by_first_line_.next(piece)) return false;
  if (piece.first_line != last_given_) ++given_;
  last_given_ = piece.first_line;
  return true;
}

double ScatteredPieces::share_given() const {
  return times_ == 0 ? 1 : static_cast<double>(given_) / static_cast<double>(times_);
}

}  // namespace thiessen
