#include "readings/readings_times.h"

#include <bit>
#include <functional>
#include <limits>

#include "base/error.h"

namespace thiessen {
namespace {

std::size_t hash_of(std::string_view time) {
  return std::hash<std::string_view>()(time);
}

std::uint32_t tag_of(std::size_t hash) {
  return static_cast<std::uint32_t>(hash >> 32);
}

}  // namespace

ReadingsTimes::Entered ReadingsTimes::enter(std::string_view time, std::size_t line) {
  if (!lines_.empty() && text(last_) == time) return {last_, false};
  if (last_ + 1 < lines_.size() && text(last_ + 1) == time) return {++last_, false};
  if (slots_.empty() && (lines_.empty() || text(last_) < time)) return append(time, line);
  if (2 * (lines_.size() + 1) > slots_.size()) grow();
  const std::size_t hash = hash_of(time);
  Slot& slot = slots_[slot_of(time, hash)];
  if (slot.number != 0) return {last_ = slot.number - 1, false};
  slot = {static_cast<std::uint32_t>(lines_.size() + 1), tag_of(hash)};
  return append(time, line);
}

ReadingsTimes::Entered ReadingsTimes::append(std::string_view time, std::size_t line) {
  if (lines_.size() + 1 == std::numeric_limits<std::uint32_t>::max()) {
    throw Error(Message{"", line, "more times than can be numbered", ""});
  }
  texts_ += time;
  ends_.push_back(texts_.size());
  lines_.push_back(line);
  last_ = static_cast<std::uint32_t>(lines_.size() - 1);
  return {last_, true};
}

std::string_view ReadingsTimes::text(std::size_t step) const {
  const std::size_t begin = step == 0 ? 0 : ends_[step - 1];
  return std::string_view(texts_).substr(begin, ends_[step] - begin);
}

std::size_t ReadingsTimes::slot_of(std::string_view time, std::size_t hash) const {
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = hash & mask;; i = (i + 1) & mask) {
    const Slot slot = slots_[i];
    if (slot.number == 0 || (slot.tag == tag_of(hash) && text(slot.number - 1) == time)) return i;
  }
}

void ReadingsTimes::grow() {
  slots_.assign(std::bit_ceil(4 * (lines_.size() + 1)), Slot{});
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t step = 0; step < lines_.size(); ++step) {
    const std::size_t hash = hash_of(text(step));
    std::size_t i = hash & mask;
    while (slots_[i].number != 0) i = (i + 1) & mask;  // all differ, so texts need no comparison
    slots_[i] = {static_cast<std::uint32_t>(step + 1), tag_of(hash)};
  }
}

}  // namespace thiessen
