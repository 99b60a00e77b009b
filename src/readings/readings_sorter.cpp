#include "readings/readings_sorter.h"

#include <algorithm>
#include <cstring>

#include "base/interrupt.h"

namespace thiessen {
namespace {

constexpr std::size_t smallest_buffer = std::size_t{4} << 10;
constexpr std::size_t largest_buffer = std::size_t{256} << 10;

/// Sorts by merging the stretches that ascend already. It is stable, and takes n log k comparisons
/// if there are k such stretches.
template <typename Items, typename Before>
void merge_stretches(Items& items, Before before) {
  std::vector<std::ptrdiff_t> ends;
  for (std::size_t i = 1; i <= items.size(); ++i) {
    if (i == items.size() || before(items[i], items[i - 1]))
      ends.push_back(static_cast<std::ptrdiff_t>(i));
  }
  if (ends.size() > items.size() / 8) {
    std::stable_sort(items.begin(), items.end(), before);
    return;
  }
  while (ends.size() > 1) {
    std::vector<std::ptrdiff_t> merged;
    std::ptrdiff_t begin = 0;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      const std::ptrdiff_t end = i + 1 < ends.size() ? ends[i + 1] : ends[i];
      std::inplace_merge(items.begin() + begin, items.begin() + ends[i], items.begin() + end,
                         before);
      merged.push_back(begin = end);
    }
    ends = std::move(merged);
  }
}

}  // namespace

void PieceSorter::add(const ReadingsPiece& piece) {
  const std::size_t held = bytes_.size() + starts_.size() * sizeof(std::size_t);
  if (!starts_.empty() && held + bytes_of(piece) > memory_) spill();
  starts_.push_back(bytes_.size());
  append_piece(bytes_, piece);
}

bool PieceSorter::next(ReadingsPiece& piece) {
  if (!reading_) begin_reading();
  throw_if_interrupted();
  if (!runs_.empty()) return next_merged(piece);
  if (given_ == starts_.size()) return false;
  const char* const bytes = bytes_.data() + starts_[given_++];
  const PieceHead head = head_at(bytes);
  const std::string_view time = time_at(bytes);
  readings_.resize(head.readings);
  if (head.readings > 0) {
    std::memcpy(readings_.data(), time.data() + time.size(), head.readings_bytes());
  }
  piece = {head.first_line, head.line, time, readings_};
  return true;
}

bool PieceSorter::comes_before(std::size_t a, std::size_t b) const {
  const char* const bytes = bytes_.data();
  if (order_ == Order::by_time) return time_at(bytes + a) < time_at(bytes + b);
  return head_at(bytes + a).first_line < head_at(bytes + b).first_line;
}

void PieceSorter::sort() {
  merge_stretches(starts_, [&](std::size_t a, std::size_t b) { return comes_before(a, b); });
}

void PieceSorter::spill() {
  sort();
  runs_.begin();
  for (const std::size_t start : starts_) {
    const PieceHead head = head_at(bytes_.data() + start);
    runs_.add(std::string_view(bytes_).substr(
        start, sizeof head + head.time_bytes + head.readings_bytes()));
  }
  bytes_.clear();
  starts_.clear();
}

void PieceSorter::begin_reading() {
  reading_ = true;
  if (runs_.empty()) {
    sort();
  } else {
    spill();
    begin_merge();
  }
}

void PieceSorter::begin_merge() {
  runs_.finish();
  std::string().swap(bytes_);
  std::vector<std::size_t>().swap(starts_);
  const std::size_t buffer =
      std::clamp(memory_ / runs_.runs().size(), smallest_buffer, largest_buffer);
  for (const PieceRuns::Run run : runs_.runs()) {
    readers_.emplace_back(runs_.file(), run, buffer);
    if (readers_.back().next()) heap_.push_back(readers_.size() - 1);
  }
  const auto later = [&](std::size_t a, std::size_t b) { return is_later(a, b); };
  std::make_heap(heap_.begin(), heap_.end(), later);
}

bool PieceSorter::is_later(std::size_t a, std::size_t b) const {
  const PieceRunReader& one = readers_[a];
  const PieceRunReader& other = readers_[b];
  if (order_ == Order::by_time) {
    const int comparison = one.time().compare(other.time());
    return comparison > 0 || (comparison == 0 && a > b);
  }
  return one.first_line() > other.first_line() || (one.first_line() == other.first_line() && a > b);
}

bool PieceSorter::next_merged(ReadingsPiece& piece) {
  const auto later = [&](std::size_t a, std::size_t b) { return is_later(a, b); };
  if (taken_from_) {
    if (readers_[*taken_from_].next()) {
      heap_.push_back(*taken_from_);
      std::push_heap(heap_.begin(), heap_.end(), later);
    }
    taken_from_.reset();
  }
  if (heap_.empty()) return false;
  std::pop_heap(heap_.begin(), heap_.end(), later);
  taken_from_ = heap_.back();
  heap_.pop_back();
  piece = readers_[*taken_from_].take(readings_);
  return true;
}

}  // namespace thiessen
