#include "outlines/geos.h"

#include <algorithm>
#include <new>
#include <vector>

namespace thiessen {

Geos::Geos() : context_(GEOS_init_r()) {
  if (context_ == nullptr) throw std::bad_alloc();
  GEOSContext_setNoticeMessageHandler_r(context_, hear, this);
  GEOSContext_setErrorMessageHandler_r(context_, hear, this);
}

Geos::~Geos() {
  GEOS_finish_r(context_);
}

// GEOS calls this from C++ by way of C: nothing may be thrown through it.
void Geos::hear(const char* message, void* self) noexcept {
  std::string& text = static_cast<Geos*>(self)->text_;
  if (!text.empty()) return;
  try {
    text = message;
  } catch (const std::bad_alloc&) {
    return;
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
}

GEOSCoordSequence* Geos::closed_points(const Ring& ring) const {
  const bool closed = ring.empty() || (ring.size() > 1 && ring.front() == ring.back());
  std::vector<double> pairs;
  pairs.reserve(2 * ring.size() + 2);
  for (const Point point : ring) pairs.insert(pairs.end(), {point.x, point.y});
  if (!closed) pairs.insert(pairs.end(), {ring.front().x, ring.front().y});
  const auto count = static_cast<unsigned>(pairs.size() / 2);
  return GEOSCoordSeq_copyFromBuffer_r(context_, pairs.data(), count, /*hasZ=*/0, /*hasM=*/0);
}

GEOSGeometry* Geos::ring_of(const Ring& ring) const {
  GEOSCoordSequence* points = closed_points(ring);
  return points == nullptr ? nullptr : GEOSGeom_createLinearRing_r(context_, points);
}

GEOSGeometry* Geos::polygon_of(const Polygon& polygon) const {
  Shape shell = own(ring_of(polygon.outer));
  std::vector<Shape> holes;
  for (const Ring& hole : polygon.holes) holes.push_back(own(ring_of(hole)));
  const auto missing = [](const Shape& shape) { return shape == nullptr; };
  if (!shell || std::any_of(holes.begin(), holes.end(), missing)) return nullptr;
  std::vector<GEOSGeometry*> taken;
  taken.reserve(holes.size());
  for (Shape& hole : holes) taken.push_back(hole.release());
  return GEOSGeom_createPolygon_r(context_, shell.release(), taken.data(),
                                  static_cast<unsigned>(taken.size()));
}

Geos::Shape Geos::shape_of(const MultiPolygon& polygons) const {
  std::vector<Shape> parts;
  for (const Polygon& polygon : polygons) {
    parts.push_back(own(polygon_of(polygon)));
    if (!parts.back()) return own(nullptr);
  }
  std::vector<GEOSGeometry*> taken;
  taken.reserve(parts.size());
  for (Shape& part : parts) taken.push_back(part.release());
  return own(GEOSGeom_createCollection_r(context_, GEOS_MULTIPOLYGON, taken.data(),
                                         static_cast<unsigned>(taken.size())));
}

Geos::Shape Geos::lines_of(std::span<const Ring> rings) const {
  std::vector<Shape> lines;
  for (const Ring& ring : rings) {
    if (ring.size() < 2) continue;
    GEOSCoordSequence* points = closed_points(ring);
    lines.push_back(
        own(points == nullptr ? nullptr : GEOSGeom_createLineString_r(context_, points)));
    if (!lines.back()) return own(nullptr);
  }
  std::vector<GEOSGeometry*> taken;
  taken.reserve(lines.size());
  for (Shape& line : lines) taken.push_back(line.release());
  return own(GEOSGeom_createCollection_r(context_, GEOS_MULTILINESTRING, taken.data(),
                                         static_cast<unsigned>(taken.size())));
}

Ring Geos::points_of(const GEOSGeometry* ring) const {
  const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(context_, ring);
  unsigned size = 0;
  if (points == nullptr || GEOSCoordSeq_getSize_r(context_, points, &size) == 0) return {};
  std::vector<double> pairs(std::size_t{2} * size);
  if (GEOSCoordSeq_copyToBuffer_r(context_, points, pairs.data(), /*hasZ=*/0, /*hasM=*/0) == 0)
    return {};
  Ring result;
  result.reserve(size);
  for (std::size_t i = 0; i < size; ++i) result.push_back({pairs[2 * i], pairs[2 * i + 1]});
  if (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

void Geos::gather(const GEOSGeometry* shape, MultiPolygon& into) const {
  if (GEOSGeomTypeId_r(context_, shape) == GEOS_POLYGON) {
    if (GEOSisEmpty_r(context_, shape) != 0) return;
    Polygon polygon;
    polygon.outer = points_of(GEOSGetExteriorRing_r(context_, shape));
    const int holes = GEOSGetNumInteriorRings_r(context_, shape);
    for (int i = 0; i < holes; ++i)
      polygon.holes.push_back(points_of(GEOSGetInteriorRingN_r(context_, shape, i)));
    into.push_back(std::move(polygon));
    return;
  }
  const int type = GEOSGeomTypeId_r(context_, shape);
  if (type != GEOS_MULTIPOLYGON && type != GEOS_GEOMETRYCOLLECTION) return;
  const int parts = GEOSGetNumGeometries_r(context_, shape);
  for (int i = 0; i < parts; ++i) gather(GEOSGetGeometryN_r(context_, shape, i), into);
}

MultiPolygon Geos::polygons_of(const GEOSGeometry* shape) const {
  MultiPolygon polygons;
  if (shape != nullptr) gather(shape, polygons);
  return polygons;
}

}  // namespace thiessen
