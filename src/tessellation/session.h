#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/error.h"
#include "tessellation/history.h"

namespace thiessen {

/// A tessellation that is changed by commands, forwards and backwards, and the numbers by which its
/// user knows the points: from 1 in the order in which they are added, and no number is used twice;
/// undo takes the number back too, and redo gives it again. Whatever cannot be done throws Error
/// with a sentence, and leaves everything as it was. Positions must be in the exact range.
template <int Dimension>
class TessellationSession {
 public:
  using Position = PositionIn<Dimension>;
  /// What came of many points at once.
  struct Added {
    std::uint64_t first = 0;   ///< number of the first new point
    std::size_t points = 0;    ///< new ones: the numbers from `first` on
    std::size_t repeated = 0;  ///< that equal another of them
    std::size_t there_already = 0;
  };

  const Tessellation<Dimension>& tessellation() const { return history_.tessellation(); }
  /// Of a point that is there.
  std::uint64_t number_of(PointId p) const { return numbers_[index(p)]; }

  /// Adds a point; returns its number. Error: there is a point already.
  std::uint64_t add(const Position& position);
  /// Adds points in their order, in one step; of equal ones, and those that are there, one.
  Added add_all(std::span<const Position> positions);
  /// Deletes the point at this very position; returns its number. Error: there is none.
  std::uint64_t remove(const Position& position);
  /// Error: there is nothing to take back, or to make again.
  void undo();
  void redo();

  /// The point at this very position. Error: there is none.
  PointId point_at(const Position& position) const;
  /// The nearest point, of equally near ones that with the lowest number. Error: there are no
  /// points.
  PointId nearest(const Position& to) const;

 private:
  struct NumberChange {
    PointId point;
    std::uint64_t number;  // before it; when undone, after it. 0 where there is no point
  };
  struct Step {
    std::size_t first;   // of its changes
    std::uint64_t next;  // number to be given before it; when undone, after it
  };

  void make_room(std::size_t points);
  void begin_step();
  void change_number(PointId p, std::uint64_t number);
  void exchange(std::size_t step);

  History<Dimension> history_;
  std::vector<std::uint64_t> numbers_;  // by PointId
  std::uint64_t next_ = 1;
  std::vector<NumberChange> changes_;
  std::vector<Step> steps_;
};

}  // namespace thiessen
