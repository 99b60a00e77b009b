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

/// A forming point's number. Point 0 lies at infinity, so that the hull's outside is made of
/// simplices like any other.
enum class PointId : std::uint32_t {};
inline constexpr PointId infinite_point{0};
inline constexpr PointId no_point{0xFFFFFFFFu};

/// A vertex of the Voronoi tessellation, and with it the Delaunay simplex that it is the centre of.
enum class VertexId : std::uint32_t {};
inline constexpr VertexId no_vertex{0xFFFFFFFFu};

constexpr std::size_t index(PointId id) {
  return static_cast<std::size_t>(id);
}
constexpr std::size_t index(VertexId id) {
  return static_cast<std::size_t>(id);
}

/// Where changes are kept. What is copied or moved is not recorded there.
template <typename Changes>
struct Recorded {
  Recorded() = default;
  Recorded(const Recorded&) {}
  Recorded& operator=(Recorded) { return *this; }
  ~Recorded() = default;

  Changes* list = nullptr;
};

/// Makes room for more elements, growing by half at least.
template <typename Element>
void reserve_more(std::vector<Element>& elements, std::size_t more) {
  const std::size_t needed = elements.size() + more;
  if (needed > elements.capacity()) {
    elements.reserve(std::max(needed, elements.capacity() + elements.capacity() / 2));
  }
}

/// The thesis' table of the structure (section 2.4): for each vertex its forming points and its
/// neighbouring vertices; neighbour i lies across from forming point i. It holds no coordinates.
/// Freed rows are used again first, and so are freed points' numbers. Where the points span less
/// than the space (dimension() < Dimension), rows have dimension() + 1 corners, and the rest of
/// them is empty. Every row but those of dimension 0 is oriented like its neighbours.
///
/// While changes are recorded, whatever is about to be overwritten is kept first, so that
/// exchange() can take the changes back, and make them again, bit for bit.
template <int Dimension>
class Topology {
 public:
  static constexpr std::size_t corners = Dimension + 1;
  using Forming = std::array<PointId, corners>;
  struct Row {
    Forming forming;
    std::array<VertexId, corners> neighbours;
  };
  /// What holds for the table as a whole.
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
  /// How many changes there are.
  struct Extent {
    std::size_t rows = 0;
    std::size_t points = 0;
  };
  struct Changes {
    std::vector<RowChange> rows;
    std::vector<PointChange> points;

    Extent extent() const { return {rows.size(), points.size()}; }
    /// Forgets those after the extent.
    void cut(const Extent& extent) {
      rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(extent.rows), rows.end());
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(extent.points), points.end());
    }
  };

  Topology() : vertex_of_(1, absent) {}

  /// Of what the points span: -1 for none, then 0 to Dimension.
  int dimension() const { return state_.dimension; }
  void set_dimension(int dimension) { state_.dimension = dimension; }
  /// Rows that were ever used: valid ids are below. Some may be free.
  std::size_t size() const { return rows_.size(); }
  bool is_free(VertexId v) const { return row(v).forming[0] == no_point; }
  const Row& row(VertexId v) const { return rows_[index(v)]; }
  const Forming& forming(VertexId v) const { return row(v).forming; }
  VertexId neighbour(VertexId v, std::size_t i) const { return row(v).neighbours[i]; }
  /// Which of v's corners the point is; `corners` where it is none.
  std::size_t corner_of(VertexId v, PointId p) const {
    std::size_t corner = corners;
    for (std::size_t i = 0; i < corners; ++i) corner = row(v).forming[i] == p ? i : corner;
    return corner;
  }
  /// Which of v's neighbours w is. Requires that it is one.
  std::size_t side_towards(VertexId v, VertexId w) const {
    std::size_t side = 0;
    for (std::size_t i = 1; i < corners; ++i) side += row(v).neighbours[i] == w ? i : 0;
    return side;
  }
  bool is_infinite(VertexId v) const { return corner_of(v, infinite_point) != corners; }
  /// Calls `visit(v)` for every vertex, those with the infinite point among them.
  template <typename Visit>
  void for_each_vertex(Visit&& visit) const {
    for (std::uint32_t i = 0; i < rows_.size(); ++i) {
      if (!is_free(VertexId{i})) visit(VertexId{i});
    }
  }

  /// Numbers that were ever given: valid ids are below. Some may be free; number 0 is the infinite
  /// point's.
  std::size_t point_limit() const { return vertex_of_.size(); }
  std::size_t count() const { return state_.points_there; }
  bool is_there(PointId p) const {
    return index(p) < vertex_of_.size() && vertex_of_[index(p)] < absent;
  }
  /// One of the vertices that the point forms. Requires that it is there.
  VertexId vertex_of(PointId p) const { return VertexId{vertex_of_[index(p)]}; }

  /// A free row, to be filled. Errors: std::length_error beyond 2^31 - 1 rows.
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
  void release(VertexId v) {
    keep(v);
    rows_[index(v)] = free_row(state_.first_free);
    state_.first_free = v;
  }
  /// For changing a row.
  Row& change(VertexId v) {
    keep(v);
    return rows_[index(v)];
  }
  /// For filling a row that was allocated, or is kept since it was changed, in this operation.
  Row& fill(VertexId v) { return rows_[index(v)]; }

  /// A free number, for a point that is there from now on. Errors: std::length_error beyond 2^31.
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

  /// Hints that the row, or which vertex the point forms, will be needed soon.
  void fetch(VertexId v) const { __builtin_prefetch(rows_.data() + index(v)); }
  void fetch(PointId p) const { __builtin_prefetch(vertex_of_.data() + index(p)); }

  /// Room for so many more points. Again and again for a few it costs no more than they do.
  void reserve(std::size_t points) {
    reserve_more(vertex_of_, points);
    reserve_more(rows_, rows_a_point * points);
  }

  /// Where what is about to be overwritten is kept from now on; nowhere for none.
  void record_in(Changes* changes) { changes_.list = changes; }
  Changes* recorded_in() const { return changes_.list; }
  const State& state() const { return state_; }
  /// Takes the changes between two extents back, `then` being the state before them; afterwards
  /// they and `then` hold what makes them again. They are gone through backward to take them back,
  /// and forward to make them again.
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
  // Marks a point's number as free; the other bits lead to the next free one.
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
  // Out of line, so that what is not recorded costs next to nothing.
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
