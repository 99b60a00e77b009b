#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tessellation/tessellation.h"

namespace thiessen {

/// A tessellation whose operations can be undone and redone, without limit and bit for bit. Kept is
/// what an operation overwrote, so undoing costs what the operation cost; where many points are
/// added at once the tessellation before them, which is less. An operation that fails half-way (out
/// of memory) is taken back, and thrown on.
/// Memory: about 800 bytes an insertion or deletion in the plane, 4 kB in space, before the slack
/// of a growing vector.
template <int Dimension>
class History {
 public:
  using Position = PositionIn<Dimension>;

  const Tessellation<Dimension>& tessellation() const { return tessellation_; }

  /// One operation each, as Tessellation's. What was undone before cannot be redone any more.
  PointId add(const Position& position, std::optional<PointId> hint = {});
  std::vector<PointId> add_all(std::span<const Position> points);
  void remove(PointId p);

  std::size_t undoable() const { return done_; }
  std::size_t redoable() const { return operations_.size() - done_; }
  /// Takes the last operation back; false where there is none.
  bool undo();
  /// Makes the operation that was undone last again; false where there is none.
  bool redo();

 private:
  using Changes = typename Structure<Dimension>::Changes;
  using Extent = typename Structure<Dimension>::Extent;
  struct Operation {
    Extent first;
    Extent end;
    typename Tessellation<Dimension>::Moment moment;  // before it; when undone, after it
    std::unique_ptr<Tessellation<Dimension>> whole;   // instead of changes
  };

  // A copy of so many points takes the place of one point's changes.
  static constexpr std::size_t changes_a_copy = Dimension == 2 ? 9 : 12;

  void forget_undone();
  template <typename Work>
  auto recorded(Work&& work);
  void exchange(Operation& operation, bool backward);

  Tessellation<Dimension> tessellation_;
  Changes changes_;
  std::vector<Operation> operations_;
  std::size_t done_ = 0;  // of the operations; those after it were undone
};

/// A change that is tried: what is done to the tessellation while the trial lasts is taken back at
/// its end, bit for bit. Trials may be nested.
/// Cost: that of the changes once more; `changes` keeps its memory for the next trial.
template <int Dimension>
class Trial {
 public:
  using Changes = typename Structure<Dimension>::Changes;

  Trial(Tessellation<Dimension>& tessellation, Changes& changes);
  ~Trial();
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

 private:
  Tessellation<Dimension>& tessellation_;
  Changes& changes_;
  typename Structure<Dimension>::Extent first_;
  typename Tessellation<Dimension>::Moment moment_;
  Changes* recorded_in_;
  bool was_tried_;
};

}  // namespace thiessen
