#include "tessellation/history.h"

#include <utility>

namespace thiessen {

// Does one operation while its changes are recorded. An operation that fails half-way is taken
// back, so that the tessellation stays as it was.
template <int Dimension>
template <typename Work>
auto History<Dimension>::recorded(Work&& work) {
  forget_undone();
  Operation operation{changes_.extent(), {}, tessellation_.moment(), nullptr};
  tessellation_.record_in(&changes_);
  const auto end = [&] {
    operation.end = changes_.extent();
    tessellation_.record_in(nullptr);
  };
  try {
    auto result = work();
    end();
    operations_.push_back(std::move(operation));
    ++done_;
    return result;
  } catch (...) {
    end();
    exchange(operation, true);
    changes_.cut(operation.first);
    throw;
  }
}

template <int Dimension>
PointId History<Dimension>::add(const Position& position, std::optional<PointId> hint) {
  return recorded([&] { return tessellation_.add(position, hint); });
}

template <int Dimension>
void History<Dimension>::remove(PointId p) {
  recorded([&] {
    tessellation_.remove(p);
    return 0;
  });
}

template <int Dimension>
std::vector<PointId> History<Dimension>::add_all(std::span<const Position> points) {
  if (changes_a_copy * points.size() < tessellation_.count())
    return recorded([&] { return tessellation_.add_all(points); });
  forget_undone();
  operations_.push_back({changes_.extent(),
                         changes_.extent(),
                         {},
                         std::make_unique<Tessellation<Dimension>>(tessellation_)});
  try {
    const std::size_t before = tessellation_.count();
    std::vector<PointId> numbers = tessellation_.add_all(points);
    Operation& operation = operations_.back();
    if (tessellation_.count() == before) operation.whole = nullptr;
    operation.moment = tessellation_.moment();
    ++done_;
    return numbers;
  } catch (...) {
    tessellation_ = std::move(*operations_.back().whole);
    operations_.pop_back();
    throw;
  }
}

template <int Dimension>
void History<Dimension>::forget_undone() {
  if (redoable() == 0) return;
  changes_.cut(operations_[done_].first);
  operations_.erase(operations_.begin() + static_cast<std::ptrdiff_t>(done_), operations_.end());
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
