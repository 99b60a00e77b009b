#include "tessellation/session.h"

#include <algorithm>
#include <string>
#include <utility>

#include "tessellation/topology_table.h"

namespace thiessen {
namespace {

[[noreturn]] void refuse(std::string text, std::string hint = {}) {
  throw Error(Message{"", 0, std::move(text), std::move(hint)});
}

}  // namespace

template <int Dimension>
std::uint64_t TessellationSession<Dimension>::add(const Position& position) {
  if (const auto there = tessellation().find(position)) {
    refuse("point " + std::to_string(number_of(*there)) + " is at " + position_text(position) +
           " already");
  }
  make_room(1);
  const PointId p = history_.add(position);
  begin_step();
  change_number(p, next_++);
  return next_ - 1;
}

template <int Dimension>
auto TessellationSession<Dimension>::add_all(std::span<const Position> positions) -> Added {
  make_room(positions.size());
  const std::vector<PointId> points = history_.add_all(positions);
  begin_step();
  Added added;
  added.first = next_;
  for (const PointId p : points) {
    const std::uint64_t number = index(p) < numbers_.size() ? numbers_[index(p)] : 0;
    if (number == 0) {
      change_number(p, next_++);
      ++added.points;
    } else {
      ++(number >= added.first ? added.repeated : added.there_already);
    }
  }
  return added;
}

template <int Dimension>
std::uint64_t TessellationSession<Dimension>::remove(const Position& position) {
  const PointId p = point_at(position);
  const std::uint64_t number = number_of(p);
  make_room(1);
  history_.remove(p);
  begin_step();
  change_number(p, 0);
  return number;
}

template <int Dimension>
void TessellationSession<Dimension>::undo() {
  if (!history_.undo()) refuse("there is nothing to undo");
  exchange(history_.undoable());
}

template <int Dimension>
void TessellationSession<Dimension>::redo() {
  if (!history_.redo()) refuse("there is nothing to redo");
  exchange(history_.undoable() - 1);
}

template <int Dimension>
PointId TessellationSession<Dimension>::point_at(const Position& position) const {
  const auto p = tessellation().find(position);
  if (!p) {
    refuse("there is no point at " + position_text(position),
           tessellation().empty() ? "" : "nearest says which is the nearest");
  }
  return *p;
}

template <int Dimension>
PointId TessellationSession<Dimension>::nearest(const Position& to) const {
  std::vector<PointId> nearest;
  tessellation().find_nearest(to, {}, nearest);
  if (nearest.empty()) refuse("there are no points");
  return *std::min_element(nearest.begin(), nearest.end(),
                           [&](PointId p, PointId q) { return number_of(p) < number_of(q); });
}

// Reserves memory for the changes of one step, because once the tessellation is changed nothing may
// fail.
template <int Dimension>
void TessellationSession<Dimension>::make_room(std::size_t points) {
  reserve_more(steps_, 1);
  reserve_more(changes_, points);
  const std::size_t limit = tessellation().topology().point_limit() + points;
  if (limit > numbers_.size()) reserve_more(numbers_, limit - numbers_.size());
}

// Begins the step of the operation just done. Steps that were undone before it are forgotten, as
// History forgets their operations.
template <int Dimension>
void TessellationSession<Dimension>::begin_step() {
  const std::size_t before = history_.undoable() - 1;
  if (before < steps_.size()) {
    changes_.erase(changes_.begin() + static_cast<std::ptrdiff_t>(steps_[before].first),
                   changes_.end());
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(before), steps_.end());
  }
  steps_.push_back({changes_.size(), next_});
}

template <int Dimension>
void TessellationSession<Dimension>::change_number(PointId p, std::uint64_t number) {
  if (index(p) >= numbers_.size()) numbers_.resize(tessellation().topology().point_limit(), 0);
  changes_.push_back({p, numbers_[index(p)]});
  numbers_[index(p)] = number;
}

// Undoes or redoes the changes of numbers in one step. A step changes no number twice, so the order
// does not matter.
template <int Dimension>
void TessellationSession<Dimension>::exchange(std::size_t step) {
  const std::size_t end = step + 1 < steps_.size() ? steps_[step + 1].first : changes_.size();
  for (std::size_t i = steps_[step].first; i < end; ++i)
    std::swap(changes_[i].number, numbers_[index(changes_[i].point)]);
  std::swap(steps_[step].next, next_);
}

template class TessellationSession<2>;
template class TessellationSession<3>;

}  // namespace thiessen
