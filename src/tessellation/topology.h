#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace thiessen {

/// The number of a forming point. Point 0 is the infinite point: with it, the outside of the hull
/// is made of simplices like any other.
enum class PointId : std::uint32_t {};
inline constexpr PointId infinite_point{0};
inline constexpr PointId no_point{0xFFFFFFFFu};

/// The number of a Voronoi vertex, and of the Delaunay simplex whose centre it is.
enum class VertexId : std::uint32_t {};
inline constexpr VertexId no_vertex{0xFFFFFFFFu};

constexpr std::size_t index(PointId id) {
  return static_cast<std::size_t>(id);
}
constexpr std::size_t index(VertexId id) {
  return static_cast<std::size_t>(id);
}

/// A pointer to the list in which changes are recorded. A copy starts without a list, and an object
/// that is assigned to keeps its own, so that only the original is recorded.
template <typename Changes>
struct Recorded {
  Recorded() = default;
  Recorded(const Recorded&) {}
  Recorded& operator=(Recorded) { return *this; }
  ~Recorded() = default;

  Changes* list = nullptr;
};

/// Reserves room for `more` further elements. The capacity grows by half at least, so that many
/// calls for a few elements stay cheap.
template <typename Element>
void reserve_more(std::vector<Element>& elements, std::size_t more) {
  const std::size_t needed = elements.size() + more;
  if (needed > elements.capacity()) {
    elements.reserve(std::max(needed, elements.capacity() + elements.capacity() / 2));
  }
}

/// The thesis' table of the structure (section 2.4): for each vertex its forming points and its
/// neighbouring vertices, where neighbour i lies across from forming point i. It holds no
/// coordinates. Freed rows and freed point numbers are used again before new ones. Where the points
/// span less than the space (dimension() < Dimension), a row uses its first dimension() + 1 corners
/// and leaves the rest empty. Every row is oriented like its neighbours, except in dimension 0.
///
/// While changes are recorded, whatever is about to be overwritten is saved first, so that
/// exchange() can undo the changes and redo them, bit for bit.
template <int Dimension>
class Topology {
 public:
  static constexpr std::size_t corners = Dimension + 1;
  using Forming = std::array<PointId, corners>;
  struct Row {
    Forming forming;
    std::array<VertexId, corners> neighbours;
  };
  /// What describes the table as a whole: its dimension, its sizes and the heads of its free lists.
  struct State {
    int dimension = -1;
    std::uint32_t rows = 0;
    VertexId first_free = no_vertex;
    std::uint32_t points = 1;
    std::uint32_t points_there = 0;
    std::uint32_t first_free_point = absent;
  };
  struct RowChange {
    VertexId vertex;
    Row row;
  };
  struct PointChange {
    PointId point;
    std::uint32_t vertex;
  };
  /// A place in the list of changes: how many of each kind come before it.
  struct Extent {
    std::size_t rows = 0;
    std::size_t points = 0;
  };
  struct Changes {
    std::vector<RowChange> rows;
    std::vector<PointChange> points;

    Extent extent() const { return {rows.size(), points.size()}; }
    /// Drops the changes that were recorded between two extents.
    void erase(const Extent& first, const Extent& end) {
      rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(first.rows),
                 rows.begin() + static_cast<std::ptrdiff_t>(end.rows));
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(first.points),
                   points.begin() + static_cast<std::ptrdiff_t>(end.points));
    }
    /// Drops the changes that were recorded after the extent.
    void cut(const Extent& extent) { erase(extent, this->extent()); }
  };

  Topology() : vertex_of_(1, absent) {}

  /// The dimension that the points span: -1 where there are none, 0 for one point, up to Dimension.
  int dimension() const { return state_.dimension; }
  void set_dimension(int dimension) { state_.dimension = dimension; }
  /// How many rows were ever used. Valid ids lie below it; some of them may be free.
  std::size_t size() const { return rows_.size(); }
  bool is_free(VertexId v) const { return row(v).forming[0] == no_point; }
  const Row& row(VertexId v) const { return rows_[index(v)]; }
  const Forming& forming(VertexId v) const { return row(v).forming; }
  VertexId neighbour(VertexId v, std::size_t i) const { return row(v).neighbours[i]; }
  /// Which corner of v the point is, or `corners` where it is none of them.
  std::size_t corner_of(VertexId v, PointId p) const {
    std::size_t corner = corners;
    for (std::size_t i = 0; i < corners; ++i) corner = row(v).forming[i] == p ? i : corner;
    return corner;
  }
  /// Which of v's neighbours w is. Requires that w is one of them.
  std::size_t side_towards(VertexId v, VertexId w) const {
    std::size_t side = 0;
    for (std::size_t i = 1; i < corners; ++i) side += row(v).neighbours[i] == w ? i : 0;
    return side;
  }
  bool is_infinite(VertexId v) const { return corner_of(v, infinite_point) != corners; }
  /// Calls `visit(v)` for every vertex in use, those with the infinite point included.
  template <typename Visit>
  void for_each_vertex(Visit&& visit) const {
    for (std::uint32_t i = 0; i < rows_.size(); ++i) {
      if (!is_free(VertexId{i})) visit(VertexId{i});
    }
  }

  /// How many point numbers were ever given, 0 of the infinite point included. Valid ids lie below
  /// it; some of them may be free.
  std::size_t point_limit() const { return vertex_of_.size(); }
  std::size_t count() const { return state_.points_there; }
  bool is_there(PointId p) const {
    return index(p) < vertex_of_.size() && vertex_of_[index(p)] < absent;
  }
  /// Any one of the vertices that the point forms. Requires that the point is there.
  VertexId vertex_of(PointId p) const { return VertexId{vertex_of_[index(p)]}; }

  /// Takes a free row, which the caller has to fill. Errors: std::length_error beyond 2^31 rows.
  VertexId allocate() {
    VertexId v = state_.first_free;
    if (v == no_vertex) {
      if (rows_.size() >= absent) throw std::length_error("more than 2^31 simplices");
      v = VertexId{static_cast<std::uint32_t>(rows_.size())};
      rows_.push_back(free_row(no_vertex));
      ++state_.rows;
    } else {
      state_.first_free = row(v).neighbours[0];
    }
    keep(v);
    return v;
  }
  /// Frees a row, which will be used again before new ones.
  void release(VertexId v) {
    keep(v);
    rows_[index(v)] = free_row(state_.first_free);
    state_.first_free = v;
  }
  /// Gives the row to be changed, after its old content has been recorded.
  Row& change(VertexId v) {
    keep(v);
    return rows_[index(v)];
  }
  /// Gives the row to be filled, without recording it. Requires that it was allocated, or recorded
  /// by change(), in this operation.
  Row& fill(VertexId v) { return rows_[index(v)]; }

  /// Takes a free number for a point, which is counted from now on. Errors: std::length_error
  /// beyond 2^31 numbers.
  PointId allocate_point() {
    PointId p{state_.first_free_point & ~absent};
    if (state_.first_free_point == absent) {
      if (vertex_of_.size() >= absent) throw std::length_error("more than 2^31 points");
      p = PointId{static_cast<std::uint32_t>(vertex_of_.size())};
      vertex_of_.push_back(absent);
      ++state_.points;
    } else {
      state_.first_free_point = vertex_of_[index(p)];
    }
    ++state_.points_there;
    return p;
  }
  /// Frees a point's number, which will be used again before new ones.
  void release_point(PointId p) {
    keep(p);
    vertex_of_[index(p)] = state_.first_free_point;
    state_.first_free_point = absent | static_cast<std::uint32_t>(p);
    --state_.points_there;
  }
  void set_vertex_of(PointId p, VertexId v) {
    keep(p);
    vertex_of_[index(p)] = static_cast<std::uint32_t>(v);
  }

  /// Gives every vertex in use the number `to[index(vertex)]`, in a table of so many rows; the rest
  /// of them is free, the lowest first. Requires different numbers below `rows`, and that nobody
  /// records changes.
  void renumber(const std::vector<VertexId>& to, std::uint32_t rows) {
    std::vector<Row> renumbered(rows, free_row(no_vertex));
    for_each_vertex([&](VertexId v) {
      Row& row = renumbered[index(to[index(v)])];
      row = rows_[index(v)];
      for (VertexId& neighbour : row.neighbours) {
        if (neighbour != no_vertex) neighbour = to[index(neighbour)];
      }
    });
    for (std::uint32_t& vertex : vertex_of_) {
      if (vertex < absent) vertex = static_cast<std::uint32_t>(to[vertex]);
    }
    rows_ = std::move(renumbered);
    state_.rows = rows;
    state_.first_free = no_vertex;
    for (std::uint32_t i = rows; i > 0; --i) {
      if (is_free(VertexId{i - 1})) release(VertexId{i - 1});
    }
  }

  /// Prefetches the row of a vertex, or the entry of a point, that will be needed soon.
  void fetch(VertexId v) const { __builtin_prefetch(rows_.data() + index(v)); }
  void fetch(PointId p) const { __builtin_prefetch(vertex_of_.data() + index(p)); }

  /// Reserves room for so many more points. Many calls for a few points each cost no more than the
  /// points themselves.
  void reserve(std::size_t points) {
    reserve_more(vertex_of_, points);
    reserve_more(rows_, rows_a_point * points);
  }

  /// Records changes in this list from now on; null ends the recording.
  void record_in(Changes* changes) { changes_.list = changes; }
  Changes* recorded_in() const { return changes_.list; }
  const State& state() const { return state_; }
  /// Undoes the recorded changes between the extents `first` and `end`, or redoes them if they were
  /// undone. `then` is the state that the table had on the other side of the changes: before them
  /// to undo, after them to redo. The saved rows and `then` are swapped with the table's own, so
  /// that afterwards they hold what the reverse call needs. A row may be recorded more than once,
  /// so undoing must go `backward`, from the last change to the first, and redoing forward.
  void exchange(Changes& changes, const Extent& first, const Extent& end, State& then,
                bool backward) {
    rows_.resize(std::max<std::size_t>(state_.rows, then.rows), free_row(no_vertex));
    vertex_of_.resize(std::max<std::size_t>(state_.points, then.points), absent);
    const auto swap_row = [&](std::size_t i) {
      std::swap(changes.rows[i].row, rows_[index(changes.rows[i].vertex)]);
    };
    const auto swap_point = [&](std::size_t i) {
      std::swap(changes.points[i].vertex, vertex_of_[index(changes.points[i].point)]);
    };
    if (backward) {
      for (std::size_t i = end.rows; i > first.rows; --i) swap_row(i - 1);
      for (std::size_t i = end.points; i > first.points; --i) swap_point(i - 1);
    } else {
      for (std::size_t i = first.rows; i < end.rows; ++i) swap_row(i);
      for (std::size_t i = first.points; i < end.points; ++i) swap_point(i);
    }
    std::swap(state_, then);
    rows_.resize(state_.rows, free_row(no_vertex));
    vertex_of_.resize(state_.points);
  }

 private:
  // This bit marks a point's number as free; the other bits then hold the next free number.
  static constexpr std::uint32_t absent = 0x80000000u;
  static constexpr std::size_t rows_a_point = Dimension == 2 ? 2 : 7;

  static Row free_row(VertexId next) {
    Row row;
    row.forming.fill(no_point);
    row.neighbours.fill(no_vertex);
    row.neighbours[0] = next;
    return row;
  }
  void keep(VertexId v) {
    if (changes_.list != nullptr) [[unlikely]]
      record(v);
  }
  void keep(PointId p) {
    if (changes_.list != nullptr) [[unlikely]]
      record(p);
  }
  // Recording is kept out of line, so that changes which are not recorded cost next to nothing.
  [[gnu::noinline]] void record(VertexId v) { changes_.list->rows.push_back({v, row(v)}); }
  [[gnu::noinline]] void record(PointId p) {
    changes_.list->points.push_back({p, vertex_of_[index(p)]});
  }

  std::vector<Row> rows_;
  std::vector<std::uint32_t> vertex_of_;
  State state_;
  Recorded<Changes> changes_;
};

}  // namespace thiessen
