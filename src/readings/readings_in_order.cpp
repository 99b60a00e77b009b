#include "readings/readings_in_order.h"

#include <limits>

#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_piece = std::size_t{64} << 10;

bool fits(std::size_t line, std::size_t from) {
  return line - from <= std::numeric_limits<std::uint32_t>::max();
}

}  // namespace

bool is_in_time_order(Table& table, TimeColumns times) {
  TimeOrder order;
  Row row;
  try {
    while (table.next(row)) {
      const std::string_view time = times.text(row);
      if (order.is_last(time) || trimmed(time).empty()) continue;
      if (!order.follows(time)) return false;
    }
  } catch (const Error&) {
    // The error is met again, and reported, when the rows are read.
  }
  return true;
}

bool OrderedPieces::next(ReadingsPiece& piece) {
  if (!has_row_ && (at_end_ || !rows_.next(row_))) return false;
  if (!order_.is_last(row_.time)) {
    if (!order_.follows(row_.time)) {
      throw Error({rows_.source().table->file(), row_.line,
                   "time " + quoted(row_.time, 80) + " was not there before: the file is changing",
                   ""});
    }
    time_ = row_.time;
    first_line_ = row_.line;
  }
  const std::size_t line = row_.line;
  readings_.clear();
  do {
    if (row_.has_station) {
      readings_.push_back(
          {row_.amount, row_.station, static_cast<std::uint32_t>(row_.line - line)});
    }
    has_row_ = rows_.next(row_);
    at_end_ = !has_row_;
  } while (has_row_ && row_.time == time_ && fits(row_.line, line) &&
           readings_.size() < longest_piece);
  piece = {first_line_, line, time_, readings_};
  return true;
}

}  // namespace thiessen
