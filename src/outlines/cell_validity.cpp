#include "outlines/cell_validity.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "outlines/sliver_collapse.h"

namespace thiessen {
namespace {

/// How much finer each grid is than the one before that would lose a cell, and how many are tried.
constexpr double finer = 100;
constexpr int grids = 3;
/// The finest grid there is, as a share of the largest coordinate.
constexpr double finest_share = 1e-15;

double largest_coordinate_of(std::span<const MultiPolygon> shapes) {
  double largest = 0;
  const auto see = [&](Point p) { largest = std::max({largest, std::abs(p.x), std::abs(p.y)}); };
  for (const MultiPolygon& shape : shapes) {
    for (const Polygon& polygon : shape)
      std::for_each(polygon.outer.begin(), polygon.outer.end(), see);
  }
  return largest;
}

bool keeps_all(std::span<const MultiPolygon> before, std::span<const MultiPolygon> after) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!before[i].empty() && after[i].empty()) return false;
  }
  return true;
}

/// Collapses what is narrow in the cells of one basin, on the coarsest grid that loses no cell.
/// Where each loses one, the cells stay as they are if they are valid so, and else lose what is
/// narrower than the finest grid. Returns whether anything was collapsed.
bool collapse(std::span<MultiPolygon> cells, double grid) {
  std::optional<std::vector<MultiPolygon>> result;
  bool lossless = false;
  const double finest = finest_share * largest_coordinate_of(cells);
  for (int i = 0; i < grids && (i == 0 || grid > finest); ++i, grid /= finer) {
    auto tried = collapsed(cells, grid);
    if (!tried) continue;
    const bool all = keeps_all(cells, *tried);
    result = std::move(tried);
    lossless = all;
    if (all) break;
  }
  if (!result || (!lossless && std::all_of(cells.begin(), cells.end(), is_writable))) return false;
  std::move(result->begin(), result->end(), cells.begin());
  return true;
}

/// Collapses what is narrow in the basins of some cells, given in rising order.
void collapse(CellShapes& cells, std::span<const std::size_t> narrow, double grid) {
  for (std::size_t k = 0; k < narrow.size();) {
    const auto [first, last] =
        std::equal_range(cells.basins.begin(), cells.basins.end(), cells.basins[narrow[k]]);
    const auto begin = static_cast<std::size_t>(first - cells.basins.begin());
    const auto end = static_cast<std::size_t>(last - cells.basins.begin());
    if (collapse(std::span(cells.shapes).subspan(begin, end - begin), grid)) ++cells.collapsed;
    while (k < narrow.size() && narrow[k] < end) ++k;
  }
}

std::vector<std::size_t> invalid(std::span<const MultiPolygon> shapes) {
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (!is_writable(shapes[i])) cells.push_back(i);
  }
  return cells;
}

}  // namespace

VertexRounding round_cells(CellShapes& cells, int decimals) {
  VertexRounding rounding(cells.shapes, decimals);
  if (rounding.narrow().empty()) return rounding;
  collapse(cells, rounding.narrow(), std::pow(10, -decimals - 1));
  return {cells.shapes, decimals};
}

std::vector<std::size_t> make_valid(CellShapes& cells, double grid) {
  std::vector<std::size_t> bad = invalid(cells.shapes);
  if (bad.empty()) return bad;
  collapse(cells, bad, grid);
  return invalid(cells.shapes);
}

double finest_grid(std::span<const MultiPolygon> shapes) {
  constexpr int digits = 11;
  const double largest = largest_coordinate_of(shapes);
  return largest > 0 ? std::pow(10, std::ceil(std::log10(largest)) - digits) : 1;
}

}  // namespace thiessen
