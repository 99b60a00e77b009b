#include "tessellation/session.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/interrupt.h"

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
  added.last = next_ - 1;
  return added;
}

template <int Dimension>
auto TessellationSession<Dimension>::restore(const NumberedTable<Dimension>& table) -> Restored {
  make_room(table.positions.size());
  Restored restored;
  const auto take = [&](std::span<const PointId> points) {
    take_step([&] { number_as_told(points, table.numbers, restored); });
  };
  if (tessellation().empty()) {
    history_.change_all(
        [&](Tessellation<Dimension>& tessellation) {
          std::vector<PointId> points = tessellation.add_all(table.positions);
          restored.keeps_vertices = arrange(tessellation, points, table);
          return points;
        },
        take);
  } else {
    restored.keeps_vertices = table.vertices.empty();
    history_.add_all(table.positions, take);
  }
  return restored;
}

// Numbers the new points as the table does, if all of its numbers are still to be given, and else
// in its order.
template <int Dimension>
void TessellationSession<Dimension>::number_as_told(std::span<const PointId> points,
                                                    std::span<const std::uint64_t> numbers,
                                                    Restored& restored) {
  const auto is_new = [&](PointId p) {
    return index(p) >= numbers_.size() || numbers_[index(p)] == 0;
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    restored.keeps_numbers = restored.keeps_numbers && (!is_new(points[i]) || numbers[i] >= next_);
  restored.first = next_;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_new(points[i])) {
      ++restored.there_already;
      continue;
    }
    if (restored.keeps_numbers) next_ = numbers[i];
    if (restored.points++ == 0) restored.first = next_;
    restored.last = next_;
    change_number(points[i], next_++);
  }
}

// Arranges the vertices as the table tells them. Returns false where it tells of numbers that are
// too large.
template <int Dimension>
bool TessellationSession<Dimension>::arrange(Tessellation<Dimension>& tessellation,
                                             std::span<const PointId> points,
                                             const NumberedTable<Dimension>& table) const {
  const auto& vertices = table.vertices;
  if (vertices.empty()) return true;
  const auto fail = [&](std::size_t line, std::string text) {
    throw Error(Message{table.file, line, std::move(text),
                        "without its lines of vertices the table is read by its points alone"});
  };
  const auto id_of = [](std::uint64_t number) {
    return VertexId{static_cast<std::uint32_t>(number - 1)};
  };
  std::vector<ArrangedVertex<Dimension>> arranged;
  arranged.reserve(vertices.size());
  bool fits = true;
  for (const NumberedVertex<Dimension>& vertex : vertices) {
    throw_if_interrupted();
    fits = fits && vertex.number <= arrangement_limit(vertices.size());
    auto& wanted = arranged.emplace_back();
    wanted.vertex = fits ? id_of(vertex.number) : no_vertex;
    for (std::size_t i = 0; i < vertex.forming.size(); ++i) {
      const auto at =
          std::lower_bound(table.numbers.begin(), table.numbers.end(), vertex.forming[i]);
      if (at == table.numbers.end() || *at != vertex.forming[i])
        fail(vertex.line, "there is no point " + std::to_string(vertex.forming[i]));
      wanted.forming[i] = points[static_cast<std::size_t>(at - table.numbers.begin())];
    }
  }
  if (!fits) return false;
  if (tessellation.topology().dimension() < Dimension)
    fail(vertices.front().line, "the points do not span enough to have vertices");
  if (const auto unfit = tessellation.arrange(arranged)) {
    if (*unfit == vertices.size())
      fail(0, "a vertex is missing: " + std::to_string(vertices.size()) +
                  " do not make a tessellation of the points; is the file whole?");
    fail(vertices[*unfit].line,
         "the points have no such vertex: " + std::to_string(vertices[*unfit].number));
  }
  const auto& topology = tessellation.topology();
  for (const NumberedVertex<Dimension>& vertex : vertices) {
    const auto& row = topology.row(id_of(vertex.number));
    for (std::size_t i = 0; i < vertex.neighbours.size(); ++i) {
      const VertexId w = row.neighbours[i];
      const std::uint64_t number = topology.is_infinite(w) ? 0 : std::uint64_t{index(w)} + 1;
      if (number != vertex.neighbours[i])
        fail(vertex.line, "neighbor " + std::to_string(i + 1) + " of vertex " +
                              std::to_string(vertex.number) + " is " + std::to_string(number) +
                              ", not " + std::to_string(vertex.neighbours[i]));
    }
  }
  return true;
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
