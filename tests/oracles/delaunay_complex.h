#pragma once

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <span>
#include <type_traits>
#include <vector>

#include "geometry/point.h"
#include "tessellation/tessellation.h"

namespace thiessen::cgal {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
template <int Dimension>
using Triangulation = std::conditional_t<Dimension == 2, CGAL::Delaunay_triangulation_2<Kernel>,
                                         CGAL::Delaunay_triangulation_3<Kernel>>;

inline Kernel::Point_2 theirs(const Point& p) {
  return {p.x, p.y};
}
inline Kernel::Point_3 theirs(const SpacePoint& p) {
  return {p.x, p.y, p.z};
}
inline Point ours(const Kernel::Point_2& p) {
  return {p.x(), p.y()};
}
inline SpacePoint ours(const Kernel::Point_3& p) {
  return {p.x(), p.y(), p.z()};
}

template <int Dimension>
Triangulation<Dimension> triangulation_of(std::span<const PositionIn<Dimension>> points) {
  std::vector<decltype(theirs(points[0]))> copies;
  for (const auto& p : points) copies.push_back(theirs(p));
  return {copies.begin(), copies.end()};
}

/// A triangulation of points that span `dimension`: the corners of its simplices and, across from
/// each, a simplex or none.
template <int Dimension>
struct Division {
  static constexpr std::size_t none = ~std::size_t{0};
  struct Simplex {
    std::array<PositionIn<Dimension>, std::size_t{Dimension} + 1> corners;
    std::array<std::size_t, std::size_t{Dimension} + 1> across;
  };

  int dimension = -1;
  std::vector<Simplex> simplices;
};

template <int Dimension>
Division<Dimension> division_of(const Tessellation<Dimension>& tessellation) {
  const Topology<Dimension>& topology = tessellation.topology();
  Division<Dimension> division{topology.dimension(), {}};
  const auto corners = static_cast<std::size_t>(topology.dimension() + 1);
  std::vector<std::size_t> number(topology.size(), Division<Dimension>::none);
  std::size_t count = 0;
  topology.for_each_vertex([&](VertexId v) {
    if (!topology.is_infinite(v)) number[index(v)] = count++;
  });
  topology.for_each_vertex([&](VertexId v) {
    if (topology.is_infinite(v)) return;
    typename Division<Dimension>::Simplex simplex;
    for (std::size_t i = 0; i < corners; ++i) {
      simplex.corners[i] = tessellation.position(topology.forming(v)[i]);
      simplex.across[i] = number[index(topology.neighbour(v, i))];
    }
    division.simplices.push_back(simplex);
  });
  return division;
}

template <typename Handle, int Dimension>
void add_simplices(const std::vector<Handle>& handles, Division<Dimension>& division) {
  std::map<Handle, std::size_t> number;
  for (const Handle& h : handles) number.emplace(h, number.size());
  for (const Handle& h : handles) {
    typename Division<Dimension>::Simplex simplex;
    for (int i = 0; i <= division.dimension; ++i) {
      const auto k = static_cast<std::size_t>(i);
      simplex.corners[k] = ours(h->vertex(i)->point());
      const auto found = number.find(h->neighbor(i));
      simplex.across[k] = found == number.end() ? Division<Dimension>::none : found->second;
    }
    division.simplices.push_back(simplex);
  }
}

inline Division<2> division_of(const Triangulation<2>& t) {
  Division<2> division{t.dimension(), {}};
  std::vector<Triangulation<2>::Face_handle> handles;
  if (t.dimension() == 2) {
    for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) handles.push_back(f);
  } else if (t.dimension() == 1) {
    for (auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e)
      handles.push_back(e->first);
  }
  add_simplices(handles, division);
  return division;
}

inline Division<3> division_of(const Triangulation<3>& t) {
  Division<3> division{t.dimension(), {}};
  std::vector<Triangulation<3>::Cell_handle> handles;
  if (t.dimension() == 3) {
    for (auto c = t.finite_cells_begin(); c != t.finite_cells_end(); ++c) handles.push_back(c);
  } else if (t.dimension() == 2) {
    for (auto f = t.finite_facets_begin(); f != t.finite_facets_end(); ++f)
      handles.push_back(f->first);
  } else if (t.dimension() == 1) {
    for (auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e)
      handles.push_back(e->first);
  }
  add_simplices(handles, division);
  return division;
}

/// Where q lies against the simplex' sphere, by CGAL's exact predicates: 1 within, 0 on it.
template <int Dimension>
int side_of_sphere(int dimension, const typename Division<Dimension>::Simplex& simplex,
                   const PositionIn<Dimension>& q) {
  const auto at = [&](std::size_t i) { return theirs(simplex.corners[i]); };
  const Kernel kernel;
  if (dimension < 2) return -1;
  if constexpr (Dimension == 2) {
    return kernel.side_of_bounded_circle_2_object()(at(0), at(1), at(2), theirs(q));
  } else {
    if (dimension == 2)
      return kernel.coplanar_side_of_bounded_circle_3_object()(at(0), at(1), at(2), theirs(q));
    return kernel.side_of_bounded_sphere_3_object()(at(0), at(1), at(2), at(3), theirs(q));
  }
}

/// The Delaunay complex that a triangulation divides into simplices: its cells, each the points of
/// one empty sphere. It is the same for every Delaunay triangulation of the same points, and a
/// triangulation whose cells these are is one. So two triangulations are the same up to ties if and
/// only if their complexes are equal. A cell's simplices hang together by facets across which the
/// points lie on one sphere.
template <int Dimension>
struct DelaunayComplex {
  int dimension = -1;
  bool is_delaunay = true;  ///< no sphere holds the point across from one of its facets
  std::vector<std::vector<PositionIn<Dimension>>> cells;  ///< in order, and so are their points
};

template <int Dimension>
DelaunayComplex<Dimension> complex_of(const Division<Dimension>& division) {
  const auto& simplices = division.simplices;
  DelaunayComplex<Dimension> complex{division.dimension, true, {}};
  std::vector<std::size_t> parent(simplices.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  const auto corners = static_cast<std::size_t>(division.dimension + 1);
  for (std::size_t v = 0; v < simplices.size(); ++v) {
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t w = simplices[v].across[i];
      if (w == Division<Dimension>::none) continue;
      std::size_t back = 0;
      while (simplices[w].across[back] != v) ++back;
      const int side =
          side_of_sphere<Dimension>(division.dimension, simplices[v], simplices[w].corners[back]);
      if (side > 0) complex.is_delaunay = false;
      if (side == 0) parent[root(v)] = root(w);
    }
  }
  std::map<std::size_t, std::vector<PositionIn<Dimension>>> cells;
  for (std::size_t v = 0; v < simplices.size(); ++v) {
    auto& cell = cells[root(v)];
    cell.insert(cell.end(), simplices[v].corners.begin(),
                simplices[v].corners.begin() + static_cast<std::ptrdiff_t>(corners));
  }
  for (auto& [first, cell] : cells) {
    std::sort(cell.begin(), cell.end());
    cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
    complex.cells.push_back(std::move(cell));
  }
  std::sort(complex.cells.begin(), complex.cells.end());
  return complex;
}

}  // namespace thiessen::cgal
