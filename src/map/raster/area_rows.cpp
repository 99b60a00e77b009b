#include "map/raster/area_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/interrupt.h"
#include "geometry/ring_location.h"

namespace thiessen {
namespace {

/// A row's first pixel whose centre lies at or to the right of where an edge crosses the row.
struct RowCrossing {
  int row;
  int column;

  friend bool operator<(RowCrossing a, RowCrossing b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  }
};

/// Pixels of a row, to be joined with those of other areas.
struct RowSpan {
  int row;
  PixelSpan pixels;
};

/// The first pixel, along an axis of `size` pixels, whose centre lies at or beyond `position`.
int first_centre(double position, int size) {
  return static_cast<int>(std::clamp(std::ceil(position - 0.5), 0.0, static_cast<double>(size)));
}

/// Adds where the edge crosses rows. `north` is the first row in the ring's rows.
void add_crossings(Point a, Point b, int north, int count, int columns,
                   std::vector<RowCrossing>& crossings) {
  a.y -= north;
  b.y -= north;
  if (b.y < a.y || (b.y == a.y && b.x < a.x)) std::swap(a, b);
  const int first = first_centre(a.y, count);
  const int end = first_centre(b.y, count);
  if (first >= end) return;
  const double slope = (b.x - a.x) / (b.y - a.y);
  for (int row = first; row < end; ++row) {
    const double x = a.x + (row + 0.5 - a.y) * slope;
    crossings.push_back({row, first_centre(x, columns)});
  }
}

}  // namespace

AreaRows::AreaRows(const PixelGrid& grid, const std::vector<MultiPolygon>& areas)
    : columns_(grid.columns) {
  for (const MultiPolygon& area : areas) {
    std::vector<PixelRing>& rings = areas_.emplace_back();
    const auto add = [&](const Ring& ring) {
      Ring pixels;
      pixels.reserve(ring.size());
      for (const Point p : ring) {
        pixels.push_back({(p.x - grid.north_west.x) / grid.pixel - grid.first_column,
                          (grid.north_west.y - p.y) / grid.pixel - grid.first_row});
      }
      const Box box = box_of(pixels);
      rings.push_back({std::move(pixels), box.low.y, box.high.y});
    };
    for (const Polygon& part : area) {
      add(part.outer);
      for (const Ring& hole : part.holes) add(hole);
    }
  }
}

AreaSpans AreaRows::rows(int row, int count) const {
  std::vector<RowSpan> all;
  std::vector<RowCrossing> crossings;
  for (const std::vector<PixelRing>& area : areas_) {
    crossings.clear();
    for (const auto& [ring, north, south] : area) {
      if (south < row || north > row + count) continue;
      throw_if_interrupted();
      for (std::size_t i = 0; i < ring.size(); ++i)
        add_crossings(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], row, count, columns_,
                      crossings);
    }
    // Each ring crosses a row an even number of times, so a row's crossings are pairs.
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const PixelSpan pixels{crossings[i].column, crossings[i + 1].column};
      if (pixels.first < pixels.end) all.push_back({crossings[i].row, pixels});
    }
  }
  std::sort(all.begin(), all.end(), [](const RowSpan& a, const RowSpan& b) {
    return a.row != b.row ? a.row < b.row : a.pixels.first < b.pixels.first;
  });
  AreaSpans spans;
  auto next = all.begin();
  for (int r = 0; r < count; ++r) {
    for (; next != all.end() && next->row == r; ++next) {
      const bool is_first = spans.spans_.size() == spans.begins_.back();
      if (!is_first && next->pixels.first <= spans.spans_.back().end) {
        spans.spans_.back().end = std::max(spans.spans_.back().end, next->pixels.end);
      } else {
        spans.spans_.push_back(next->pixels);
      }
    }
    spans.begins_.push_back(spans.spans_.size());
  }
  return spans;
}

}  // namespace thiessen
