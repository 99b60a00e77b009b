#include "tessellation/history.h"

#include <utility>

namespace thiessen {

// Does one operation while its changes are recorded. An operation that fails half-way, or that the
// witness does not let pass, is taken back, so that the tessellation stays as it was. Its changes
// are recorded behind those of undone operations, which are forgotten only once it is sure to stay.
template <int Dimension>
template <typename Work>
void History<Dimension>::recorded(Work&& work) {
  reserve_more(operations_, 1);
  Operation operation{changes_.extent(), {}, tessellation_.moment(), nullptr};
  const auto end = [&] {
    operation.end = changes_.extent();
    tessellation_.record_in(nullptr);
  };
  tessellation_.record_in(&changes_);
  try {
    work(end);
  } catch (...) {
    end();
    exchange(operation, true);
    changes_.cut(operation.first);
    throw;
  }
  keep(std::move(operation));
}

// Puts an operation in the place of those that were undone.
template <int Dimension>
void History<Dimension>::keep(Operation operation) {
  if (redoable() > 0) {
    const Extent first = operations_[done_].first;
    changes_.erase(first, operation.first);
    operation.first = first;
    operation.end = changes_.extent();
    operations_.erase(operations_.begin() + static_cast<std::ptrdiff_t>(done_), operations_.end());
  }
  operations_.push_back(std::move(operation));
  ++done_;
}

template <int Dimension>
PointId History<Dimension>::add(const Position& position, std::optional<PointId> hint,
                                const Witness& witness) {
  PointId p = no_point;
  recorded([&](const auto& end) {
    p = tessellation_.add(position, hint);
    end();
    if (witness) witness({&p, 1});
  });
  return p;
}

template <int Dimension>
void History<Dimension>::remove(PointId p, const Witness& witness) {
  recorded([&](const auto& end) {
    tessellation_.remove(p);
    end();
    if (witness) witness({});
  });
}

template <int Dimension>
std::vector<PointId> History<Dimension>::add_all(std::span<const Position> points,
                                                 const Witness& witness) {
  std::vector<PointId> numbers;
  if (changes_a_copy * points.size() < tessellation_.count()) {
    recorded([&](const auto& end) {
      numbers = tessellation_.add_all(points);
      end();
      if (witness) witness(numbers);
    });
    return numbers;
  }
  change_all(
      [&](Tessellation<Dimension>& tessellation) { return numbers = tessellation.add_all(points); },
      witness);
  return numbers;
}

template <int Dimension>
void History<Dimension>::change_all(
    const std::function<std::vector<PointId>(Tessellation<Dimension>&)>& work,
    const Witness& witness) {
  reserve_more(operations_, 1);
  auto whole = std::make_unique<Tessellation<Dimension>>(tessellation_);
  try {
    const std::vector<PointId> points = work(tessellation_);
    if (witness) witness(points);
  } catch (...) {
    tessellation_ = std::move(*whole);
    throw;
  }
  if (tessellation_.count() == whole->count()) whole = nullptr;
  keep({changes_.extent(), changes_.extent(), tessellation_.moment(), std::move(whole)});
}

template <int Dimension>
bool History<Dimension>::undo() {
  if (done_ == 0) return false;
  exchange(operations_[--done_], true);
  return true;
}

template <int Dimension>
bool History<Dimension>::redo() {
  if (redoable() == 0) return false;
  exchange(operations_[done_++], false);
  return true;
}

template <int Dimension>
void History<Dimension>::exchange(Operation& operation, bool backward) {
  if (operation.whole != nullptr) {
    std::swap(tessellation_, *operation.whole);
    return;
  }
  tessellation_.exchange(changes_, operation.first, operation.end, operation.moment, backward);
}

template <int Dimension>
Trial<Dimension>::Trial(Tessellation<Dimension>& tessellation, Changes& changes)
    : tessellation_(tessellation),
      changes_(changes),
      first_(changes.extent()),
      moment_(tessellation.moment()),
      recorded_in_(tessellation.structure().recorded_in()),
      was_tried_(tessellation.is_tried()) {
  tessellation_.record_in(&changes_, true);
}

template <int Dimension>
Trial<Dimension>::~Trial() {
  tessellation_.exchange(changes_, first_, changes_.extent(), moment_, true);
  changes_.cut(first_);
  tessellation_.record_in(recorded_in_, was_tried_);
}

template class History<2>;
template class History<3>;
template class Trial<2>;
template class Trial<3>;

}  // namespace thiessen
