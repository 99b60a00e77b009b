#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "tessellation/tessellation.h"

namespace thiessen {

/// A tessellation whose operations can be undone and redone, without limit and bit for bit. Each
/// operation keeps what it overwrote, so undoing it costs as much as the operation did. Where many
/// points are added at once, a copy of the tessellation before them is kept instead, because that
/// takes less memory. An operation that fails half-way (out of memory, Ctrl-C) is taken back before
/// its exception is passed on: then all is as it was, and what was undone can still be redone.
///
/// Memory: about 800 bytes for each insertion or deletion in the plane and 4 kB in space, not
/// counting the spare capacity of a growing vector.
template <int Dimension>
class History {
 public:
  using Position = PositionIn<Dimension>;
  /// Sees the tessellation when an operation is done but not kept yet, with the points that it
  /// added or found there. Where it throws, the operation is taken back.
  using Witness = std::function<void(std::span<const PointId> points)>;

  const Tessellation<Dimension>& tessellation() const { return tessellation_; }

  /// Adds one point, as Tessellation::add. Each of add, add_all and remove is one operation, and
  /// makes operations that were undone before it impossible to redo.
  PointId add(const Position& position, std::optional<PointId> hint = {},
              const Witness& witness = {});
  /// Adds points, as Tessellation::add_all, in one operation.
  std::vector<PointId> add_all(std::span<const Position> points, const Witness& witness = {});
  /// Does any work on the tessellation in one operation, of which a copy of the tessellation before
  /// it is kept. `work` returns the points for the witness.
  void change_all(const std::function<std::vector<PointId>(Tessellation<Dimension>&)>& work,
                  const Witness& witness = {});
  /// Deletes a point, as Tessellation::remove, in one operation.
  void remove(PointId p, const Witness& witness = {});

  /// How many operations can be undone.
  std::size_t undoable() const { return done_; }
  /// How many operations were undone and can be redone.
  std::size_t redoable() const { return operations_.size() - done_; }
  /// Undoes the last operation. Returns false where there is none.
  bool undo();
  /// Redoes the operation that was undone last. Returns false where there is none.
  bool redo();

 private:
  using Changes = typename Structure<Dimension>::Changes;
  using Extent = typename Structure<Dimension>::Extent;
  struct Operation {
    Extent first;
    Extent end;
    typename Tessellation<Dimension>::Moment moment;  // before it, or after it once undone
    std::unique_ptr<Tessellation<Dimension>> whole;   // a copy in place of changes, or null
  };

  // A copy of the tessellation takes about as much memory for this many of its points as the
  // changes of one added point take. add_all compares the two by it.
  static constexpr std::size_t changes_a_copy = Dimension == 2 ? 9 : 12;

  template <typename Work>
  void recorded(Work&& work);
  void keep(Operation operation);
  void exchange(Operation& operation, bool backward);

  Tessellation<Dimension> tessellation_;
  Changes changes_;
  std::vector<Operation> operations_;
  std::size_t done_ = 0;  // how many operations are in effect; those after them were undone
};

/// A trial of changes: whatever is done to the tessellation while this object lives is undone by
/// its destructor, bit for bit. Trials may be nested.
///
/// Cost: that of the changes once more. `changes` keeps its memory for the next trial.
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
