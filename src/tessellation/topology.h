#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace thiessen {

/// A forming point's number. The point at infinity has a number of its own, so that the hull's
/// outside is made of simplices like any other.
enum class PointId : std::uint32_t {};
inline constexpr PointId infinite_point{0xFFFFFFFFu};

/// A vertex of the Voronoi tessellation, and with it the Delaunay simplex that it is the centre of.
enum class VertexId : std::uint32_t {};
inline constexpr VertexId no_vertex{0xFFFFFFFFu};

constexpr std::size_t index(PointId id) {
  return static_cast<std::size_t>(id);
}
constexpr std::size_t index(VertexId id) {
  return static_cast<std::size_t>(id);
}

/// The thesis' table of the structure (section 2.4): for each vertex its forming points and its
/// neighbouring vertices; neighbour i lies across from forming point i. It holds no coordinates.
/// Freed rows are used again first. `Dimension` + 1 forming points a row.
template <int Dimension>
class Topology {
 public:
  static constexpr std::size_t corners = Dimension + 1;
  using Forming = std::array<PointId, corners>;

  /// Rows that were ever used: valid ids are below. Some may be free.
  std::size_t size() const { return rows_.size(); }
  bool is_free(VertexId v) const { return row(v).free; }
  const Forming& forming(VertexId v) const { return row(v).forming; }
  VertexId neighbour(VertexId v, std::size_t i) const { return row(v).neighbours[i]; }

  VertexId allocate(const Forming& forming) {
    VertexId v = first_free_;
    if (v == no_vertex) {
      v = VertexId{static_cast<std::uint32_t>(rows_.size())};
      rows_.emplace_back();
    } else {
      first_free_ = row(v).neighbours[0];
    }
    Row& r = row(v);
    r.forming = forming;
    r.neighbours.fill(no_vertex);
    r.free = false;
    return v;
  }
  void release(VertexId v) {
    Row& r = row(v);
    r.free = true;
    r.neighbours[0] = first_free_;
    first_free_ = v;
  }
  void set_neighbour(VertexId v, std::size_t i, VertexId neighbour) {
    row(v).neighbours[i] = neighbour;
  }
  void link(VertexId v, std::size_t i, VertexId w, std::size_t j) {
    set_neighbour(v, i, w);
    set_neighbour(w, j, v);
  }
  /// Which of v's corners the point is; `corners` where it is none.
  std::size_t corner_of(VertexId v, PointId p) const {
    std::size_t i = 0;
    while (i < corners && row(v).forming[i] != p) ++i;
    return i;
  }
  /// Which of v's neighbours w is. Requires that it is one.
  std::size_t side_towards(VertexId v, VertexId w) const {
    std::size_t i = 0;
    while (row(v).neighbours[i] != w) ++i;
    return i;
  }
  bool is_infinite(VertexId v) const { return corner_of(v, infinite_point) != corners; }

 private:
  struct Row {
    Forming forming;
    std::array<VertexId, corners> neighbours;
    bool free = false;
  };
  Row& row(VertexId v) { return rows_[index(v)]; }
  const Row& row(VertexId v) const { return rows_[index(v)]; }

  std::vector<Row> rows_;
  VertexId first_free_ = no_vertex;
};

}  // namespace thiessen
