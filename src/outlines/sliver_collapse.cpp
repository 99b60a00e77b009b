#include "outlines/sliver_collapse.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "outlines/polygon_validity.h"
#include "outlines/ring_faces.h"
#include "outlines/vertex_rounding.h"
#include "outlines/winding_index.h"

namespace thiessen {
namespace {

/// The rings of cells, one after the other, and the cell of each. Cells of gauges at one place are
/// the same ground, which is here once.
struct CellRings {
  std::vector<Ring> rings;
  std::vector<std::size_t> cells;
  std::vector<std::size_t> same_as;  ///< for each cell the first one with its shape

  explicit CellRings(std::span<const MultiPolygon> shapes) {
    std::map<Ring, std::size_t> seen;
    for (std::size_t cell = 0; cell < shapes.size(); ++cell) {
      same_as.push_back(cell);
      if (shapes[cell].empty()) continue;
      const auto [first, is_new] = seen.emplace(shapes[cell].front().outer, cell);
      same_as.back() = first->second;
      if (!is_new) continue;
      for (const Polygon& polygon : shapes[cell]) {
        add(polygon.outer, cell);
        for (const Ring& hole : polygon.holes) add(hole, cell);
      }
    }
  }
  void add(const Ring& ring, std::size_t cell) {
    rings.push_back(ring);
    cells.push_back(cell);
  }
};

/// The first cell that holds a point, or `none`.
std::size_t owner_of(Point p, const WindingIndex& index, const CellRings& all, std::size_t none) {
  std::map<std::size_t, int> times;
  for (const auto& [ring, winding] : index.at(p)) times[all.cells[ring]] += winding;
  const auto owner =
      std::find_if(times.begin(), times.end(), [](const auto& cell) { return cell.second > 0; });
  return owner == times.end() ? none : owner->first;
}

template <typename Change>
void for_each_point(std::vector<MultiPolygon>& cells, const Change& change) {
  for (MultiPolygon& cell : cells) {
    for (Polygon& polygon : cell) {
      std::for_each(polygon.outer.begin(), polygon.outer.end(), change);
      for (Ring& hole : polygon.holes) std::for_each(hole.begin(), hole.end(), change);
    }
  }
}

/// Gives vertices their bits back where one vertex alone moved to a point of the grid.
std::vector<MultiPolygon> with_own_vertices(std::vector<MultiPolygon> cells, const CellRings& all,
                                            double grid) {
  const double scale = 1 / grid;
  std::map<Point, std::optional<Point>> moved;
  for (const Ring& ring : all.rings) {
    for (const Point p : ring) {
      const Point at{std::round(p.x * scale) / scale, std::round(p.y * scale) / scale};
      const auto [entry, is_new] = moved.emplace(at, p);
      if (!is_new && entry->second != p) entry->second.reset();
    }
  }
  for_each_point(cells, [&](Point& p) {
    const auto found = moved.find(p);
    if (found != moved.end() && found->second) p = *found->second;
  });
  return cells;
}

double length_of(const CellRings& all) {
  double length = 0;
  for (const Ring& ring : all.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[i + 1 < ring.size() ? i + 1 : 0];
      length += std::hypot(b.x - a.x, b.y - a.y);
    }
  }
  return length;
}

double area_of_all(std::span<const MultiPolygon> cells, const CellRings& all) {
  double area = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (all.same_as[i] == i) area += plane_area(cells[i]);
  }
  return area;
}

}  // namespace

std::optional<std::vector<MultiPolygon>> collapsed(std::span<const MultiPolygon> cells,
                                                   double grid) {
  const CellRings all(cells);
  const std::vector<RingFace> faces = faces_of(all.rings, grid);
  const WindingIndex index(all.rings);
  std::vector<std::vector<const RingFace*>> owned(cells.size());
  for (const RingFace& face : faces) {
    const std::size_t owner = owner_of(face.within, index, all, cells.size());
    if (owner < cells.size()) owned[owner].push_back(&face);
  }
  std::vector<MultiPolygon> result;
  result.reserve(cells.size());
  for (const std::size_t first : all.same_as) result.push_back(united(owned[first]));
  constexpr double slivers = 100;
  const double change = std::abs(area_of_all(result, all) - area_of_all(cells, all));
  if (change > slivers * grid * length_of(all)) return std::nullopt;
  std::vector<MultiPolygon> own = with_own_vertices(result, all, grid);
  if (std::all_of(own.begin(), own.end(), is_writable)) return own;
  return result;
}

}  // namespace thiessen
