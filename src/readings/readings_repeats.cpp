#include "readings/readings_repeats.h"

#include <utility>

#include "base/utf8.h"

namespace thiessen {

RepeatedTimes::RepeatedTimes(std::unique_ptr<Table> again, TimeColumns columns, std::size_t memory)
    : again_(std::move(again)),
      columns_(std::move(columns)),
      times_(PieceSorter::Order::by_time, memory) {}

void RepeatedTimes::note(std::string_view time, std::size_t line) {
  order_.follows(time);
  if (!again_) gather(time, line);
}

void RepeatedTimes::gather(std::string_view time, std::size_t line) {
  times_.add({line, line, time, {}});
}

bool RepeatedTimes::next(Repeat& repeat) {
  if (order_.holds()) return false;
  if (!std::exchange(begun_, true) && again_) read_again();
  ReadingsPiece piece;
  while (times_.next(piece)) {
    if (first_line_ != 0 && piece.time == time_) {
      repeat = {time_, piece.line, first_line_};
      return true;
    }
    time_ = piece.time;
    first_line_ = piece.line;
  }
  return false;
}

void RepeatedTimes::read_again() {
  Row row;
  try {
    while (again_->next(row)) {
      const std::string_view time = columns_.text(row);
      if (!trimmed(time).empty()) gather(time, row.line);
    }
  } catch (const Error&) {
    // The reader of the rows met the error before, and reports it.
  }
}

}  // namespace thiessen
