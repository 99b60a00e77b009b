#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "base/error.h"
#include "tessellation/history.h"
#include "tessellation/topology_table_reader.h"

namespace thiessen {

/// A tessellation that commands change, undo and redo, and the numbers by which its user knows the
/// points. Numbers count from 1 in the order in which points are added, and none is used twice;
/// undo takes a number back too, and redo gives it again. A command that cannot be carried out
/// throws Error with a sentence, and leaves everything as it was, what can be redone included; so
/// does one that Ctrl-C interrupts. Requires positions in the exact range.
template <int Dimension>
class TessellationSession {
 public:
  using Position = PositionIn<Dimension>;
  /// The result of adding many points at once.
  struct Added {
    std::uint64_t first = 0;   ///< number of the first new point
    std::size_t points = 0;    ///< how many are new: they have the numbers from `first` on
    std::size_t repeated = 0;  ///< how many equal another of the new ones
    std::size_t there_already = 0;
    std::uint64_t last = 0;  ///< number of the last new point
  };
  /// The result of taking in a table that a session has printed.
  struct Restored : Added {
    bool keeps_numbers = true;   ///< whether the new points have the table's numbers
    bool keeps_vertices = true;  ///< whether the vertices have; so they do where it tells of none
  };

  const Tessellation<Dimension>& tessellation() const { return history_.tessellation(); }
  /// The user's number of a point. Requires that the point is there.
  std::uint64_t number_of(PointId p) const { return numbers_[index(p)]; }

  /// Has `watcher` see the tessellation after each change, and before the change is kept: where the
  /// watcher throws, the change is taken back, and the exception passed on. None: nobody watches.
  void watch(std::function<void()> watcher) { watcher_ = std::move(watcher); }

  /// Adds a point and returns its number. Error: there is a point at this position already.
  std::uint64_t add(const Position& position);
  /// Adds points in their order, as one step for undo. Of equal points one is added, and none where
  /// one is there already.
  Added add_all(std::span<const Position> positions);
  /// Adds the points of a table that a session has printed, as one step for undo. New points have
  /// the numbers of the table where none of these was ever given, and else are numbered on. Where
  /// there was no point before, the vertices have the numbers of the table too, and the order of
  /// their forming points, so that the same lines are printed as where it came from; numbers beyond
  /// arrangement_limit are not kept. Error, with the line: a vertex that the points do not have, or
  /// one that the table lacks, though it has others.
  Restored restore(const NumberedTable<Dimension>& table);
  /// Deletes the point at exactly this position and returns its number. Error: there is none.
  std::uint64_t remove(const Position& position);
  /// Undoes the last step. Error: there is nothing to undo.
  void undo();
  /// Redoes the step that was undone last. Error: there is nothing to redo.
  void redo();

  /// The point at exactly this position. Error: there is none.
  PointId point_at(const Position& position) const;
  /// The nearest point; of equally near ones the one with the lowest number. Error: there are no
  /// points.
  PointId nearest(const Position& to) const;

 private:
  struct NumberChange {
    PointId point;
    std::uint64_t number;  // before the step, or after it once undone; 0 where there is no point
  };
  struct Step {
    std::size_t first;   // index of the step's first change
    std::uint64_t next;  // the next number to give: before the step, or after it once undone
  };

  void make_room(std::size_t points);
  template <typename Numbering>
  void take_step(Numbering&& numbering);
  void keep(Step step);
  void number_one_of_many(PointId p, Added& added);
  void number_as_told(std::span<const PointId> points, std::span<const std::uint64_t> numbers,
                      Restored& restored);
  bool arrange(Tessellation<Dimension>& tessellation, std::span<const PointId> points,
               const NumberedTable<Dimension>& table) const;
  bool step_back();
  bool step_forward();
  void change_number(PointId p, std::uint64_t number);
  void exchange(std::size_t step);

  History<Dimension> history_;
  std::vector<std::uint64_t> numbers_;  // by PointId
  std::uint64_t next_ = 1;
  std::vector<NumberChange> changes_;
  std::vector<Step> steps_;
  std::function<void()> watcher_;
};

}  // namespace thiessen
