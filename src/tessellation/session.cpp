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
  history_.add(position, {}, [this](std::span<const PointId> points) {
    take_step([&] { change_number(points.front(), next_++); });
  });
  return next_ - 1;
}

template <int Dimension>
auto TessellationSession<Dimension>::add_all(std::span<const Position> positions) -> Added {
  make_room(positions.size());
  Added added;
  added.first = next_;
  history_.add_all(positions, [&](std::span<const PointId> points) {
    take_step([&] {
      for (const PointId p : points) number_one_of_many(p, added);
    });
  });
  return added;
}

template <int Dimension>
void TessellationSession<Dimension>::number_one_of_many(PointId p, Added& added) {
  const std::uint64_t number = index(p) < numbers_.size() ? numbers_[index(p)] : 0;
  if (number == 0) {
    change_number(p, next_++);
    ++added.points;
  } else {
    ++(number >= added.first ? added.repeated : added.there_already);
  }
}

template <int Dimension>
std::uint64_t TessellationSession<Dimension>::remove(const Position& position) {
  const PointId p = point_at(position);
  const std::uint64_t number = number_of(p);
  make_room(1);
  history_.remove(p, [&](std::span<const PointId>) { take_step([&] { change_number(p, 0); }); });
  return number;
}

template <int Dimension>
void TessellationSession<Dimension>::undo() {
  if (!step_back()) refuse("there is nothing to undo");
  try {
    if (watcher_) watcher_();
  } catch (...) {
    step_forward();
    throw;
  }
}

template <int Dimension>
void TessellationSession<Dimension>::redo() {
  if (!step_forward()) refuse("there is nothing to redo");
  try {
    if (watcher_) watcher_();
  } catch (...) {
    step_back();
    throw;
  }
}

template <int Dimension>
bool TessellationSession<Dimension>::step_back() {
  if (!history_.undo()) return false;
  exchange(history_.undoable());
  return true;
}

template <int Dimension>
bool TessellationSession<Dimension>::step_forward() {
  if (!history_.redo()) return false;
  exchange(history_.undoable() - 1);
  return true;
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

// Numbers the points of the operation just done, and shows it to the watcher. The changes of
// numbers stand behind those of undone steps until the watcher has let the operation pass; where he
// has not, the numbers are as before, and History takes back the operation.
template <int Dimension>
template <typename Numbering>
void TessellationSession<Dimension>::take_step(Numbering&& numbering) {
  const Step step{changes_.size(), next_};
  try {
    numbering();
    if (watcher_) watcher_();
  } catch (...) {
    for (std::size_t i = step.first; i < changes_.size(); ++i)
      numbers_[index(changes_[i].point)] = changes_[i].number;
    changes_.erase(changes_.begin() + static_cast<std::ptrdiff_t>(step.first), changes_.end());
    next_ = step.next;
    throw;
  }
  keep(step);
}

// Puts a step in the place of those that were undone, as History does with the operation.
template <int Dimension>
void TessellationSession<Dimension>::keep(Step step) {
  const std::size_t before = history_.undoable();
  if (before < steps_.size()) {
    const std::size_t first = steps_[before].first;
    changes_.erase(changes_.begin() + static_cast<std::ptrdiff_t>(first),
                   changes_.begin() + static_cast<std::ptrdiff_t>(step.first));
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(before), steps_.end());
    step.first = first;
  }
  steps_.push_back(step);
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
