#include "map/raster/area_rows.h"

#include <utility>

#include "geometry/ring_location.h"
#include "map/ink/scanline.h"

namespace thiessen {

AreaRows::AreaRows(const PixelGrid& grid, const std::vector<MultiPolygon>& areas)
    : columns_(grid.columns) {
  for (const MultiPolygon& area : areas) {
    std::vector<PixelRing>& rings = areas_.emplace_back();
    const auto add = [&](const Ring& ring) {
      Ring pixels;
      pixels.reserve(ring.size());
      for (const Point p : ring) {
        pixels.push_back(
            {(p.x - grid.north_west.x) / grid.pixel, (grid.north_west.y - p.y) / grid.pixel});
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

std::vector<std::int32_t> AreaRows::rows(int row, int count, std::int32_t inside) const {
  OwnerRaster raster(columns_, count, 0);
  std::vector<Ring> rings;
  for (const std::vector<PixelRing>& area : areas_) {
    rings.clear();
    for (const PixelRing& ring : area) {
      if (ring.south < row || ring.north > row + count) continue;
      Ring& shifted = rings.emplace_back(ring.ring);
      for (Point& p : shifted) p.y -= row;
    }
    if (!rings.empty()) raster.fill(rings, inside);
  }
  return std::move(raster).take_owners();
}

}  // namespace thiessen
