#include "gdal/layers/geometry_conversion.h"

#include <algorithm>
#include <utility>

namespace thiessen {
namespace {

Ring ring_of(const OGRSimpleCurve& line) {
  Ring ring;
  ring.reserve(static_cast<std::size_t>(line.getNumPoints()));
  for (int i = 0; i < line.getNumPoints(); ++i) ring.push_back({line.getX(i), line.getY(i)});
  return ring;
}

Polygon polygon_of(const OGRPolygon& shape) {
  Polygon polygon;
  if (shape.getExteriorRing() != nullptr) polygon.outer = ring_of(*shape.getExteriorRing());
  for (int i = 0; i < shape.getNumInteriorRings(); ++i) {
    polygon.holes.push_back(ring_of(*shape.getInteriorRing(i)));
  }
  return polygon;
}

std::unique_ptr<OGRLinearRing> ogr_ring(const Ring& ring) {
  auto line = std::make_unique<OGRLinearRing>();
  line->setNumPoints(static_cast<int>(ring.size()), FALSE);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    line->setPoint(static_cast<int>(i), ring[i].x, ring[i].y);
  }
  line->closeRings();
  return line;
}

void gather(const OGRGeometry& geometry, MultiPolygon& into) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPolygon) {
    if (geometry.IsEmpty() == FALSE) into.push_back(polygon_of(*geometry.toPolygon()));
  } else if (type == wkbMultiPolygon || type == wkbGeometryCollection) {
    for (const auto* part : *geometry.toGeometryCollection()) gather(*part, into);
  }
}

void open(Ring& ring) {
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

}  // namespace

GeometryRecord record_of(const OGRGeometry* geometry) {
  GeometryRecord record;
  if (geometry == nullptr) return record;
  std::unique_ptr<OGRGeometry> straight;
  if (geometry->hasCurveGeometry() != FALSE) {
    straight.reset(geometry->getLinearGeometry());
    if (straight) geometry = straight.get();
  }
  const OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
  record.has_z = geometry->Is3D() != FALSE;
  record.type = OGRGeometryTypeToName(type);
  record.type.erase(std::remove(record.type.begin(), record.type.end(), ' '), record.type.end());
  if (geometry->IsEmpty() != FALSE) return record;
  if (type == wkbPoint) {
    record.points.push_back({geometry->toPoint()->getX(), geometry->toPoint()->getY()});
  } else if (type == wkbMultiPoint) {
    for (const OGRPoint* point : *geometry->toMultiPoint()) {
      record.points.push_back({point->getX(), point->getY()});
    }
  } else if (type == wkbPolygon || type == wkbMultiPolygon) {
    gather(*geometry, record.polygons);
  }
  return record;
}

std::unique_ptr<OGRMultiPolygon> ogr_shape(const MultiPolygon& shape) {
  auto all = std::make_unique<OGRMultiPolygon>();
  for (const Polygon& polygon : shape) {
    auto part = std::make_unique<OGRPolygon>();
    part->addRingDirectly(ogr_ring(polygon.outer).release());
    for (const Ring& hole : polygon.holes) part->addRingDirectly(ogr_ring(hole).release());
    all->addGeometryDirectly(part.release());
  }
  return all;
}

MultiPolygon polygons_of(const OGRGeometry& geometry) {
  MultiPolygon shape;
  gather(geometry, shape);
  for (Polygon& polygon : shape) {
    open(polygon.outer);
    for (Ring& hole : polygon.holes) open(hole);
  }
  return shape;
}

}  // namespace thiessen
