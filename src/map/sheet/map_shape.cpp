#include "map/sheet/map_shape.h"

#include <algorithm>
#include <cmath>

namespace thiessen {
namespace {

constexpr int most_halvings = 8;

Point midpoint(Point a, Point b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

/// Projects rings edge by edge, and subdivides edges that the projection bends.
class Drawer {
 public:
  Drawer(const MapProjection& projection, double tolerance)
      : projection_(projection), tolerance_(tolerance) {}

  /// Adds the points of the curved edge after its first, up to and including its last.
  void edge(Point a, Point b, std::vector<Point>& out) const {
    const Point end = projection_(b);
    if (projection_.kind() == MapProjection::Kind::stereographic) {
      between(a, projection_(a), b, end, most_halvings, out);
    }
    out.push_back(end);
  }

  Point point(Point p) const { return projection_(p); }

 private:
  /// Adds the points strictly between the ends, by at most `halvings` nested halvings.
  void between(Point a, Point map_a, Point b, Point map_b, int halvings,
               std::vector<Point>& out) const {
    const Point middle = midpoint(a, b);
    const Point map_middle = projection_(middle);
    const Point chord = midpoint(map_a, map_b);
    const double sag = std::hypot(map_middle.x - chord.x, map_middle.y - chord.y);
    // The middle of a long curved edge may lie on its chord by symmetry, so a long edge is always
    // halved.
    const bool is_long = std::abs(a.x - b.x) + std::abs(a.y - b.y) > 20;
    if (halvings == 0 || (sag < tolerance_ && !is_long)) return;
    between(a, map_a, middle, map_middle, halvings - 1, out);
    out.push_back(map_middle);
    between(middle, map_middle, b, map_b, halvings - 1, out);
  }

  const MapProjection& projection_;
  double tolerance_;
};

bool on_antimeridian(Point p) {
  return std::abs(std::remainder(p.x, 360.0)) == 180;
}

bool along_antimeridian(Point a, Point b) {
  return on_antimeridian(a) && on_antimeridian(b);
}

bool along_pole(Point a, Point b) {
  return a.y == b.y && std::abs(a.y) == 90;
}

/// Whether the shape lies on both sides of the antimeridian, cut in two by it.
bool cut_by_antimeridian(const MultiPolygon& shape) {
  bool east = false;
  bool west = false;
  const auto look = [&](const Ring& ring) {
    for (const Point p : ring) {
      east = east || p.x == 180;
      west = west || p.x == -180;
    }
  };
  for (const Polygon& polygon : shape) {
    look(polygon.outer);
    for (const Ring& hole : polygon.holes) look(hole);
  }
  return east && west;
}

/// A ring in the study's coordinates, and what tells which of its edges are no outline to draw.
struct DrawnRing {
  Ring ring;
  /// The number of edges of the outline; edges after them close the ring over a pole.
  std::size_t outline;
  bool geographic;
  bool cut;  ///< the antimeridian cuts the shape in two

  bool hides(std::size_t edge, Point a, Point b) const {
    return edge >= outline || (geographic && along_pole(a, b)) || (cut && along_antimeridian(a, b));
  }
};

void add_ring(const DrawnRing& drawn, const Drawer& drawer, MapPart& part) {
  const Ring& ring = drawn.ring;
  if (ring.empty()) return;
  std::vector<Point> line{drawer.point(ring.front())};
  Ring outline = line;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const std::size_t before = outline.size();
    drawer.edge(a, b, outline);
    if (!drawn.hides(i, a, b)) {
      line.insert(line.end(), outline.begin() + static_cast<std::ptrdiff_t>(before), outline.end());
      continue;
    }
    if (line.size() > 1) part.lines.push_back(std::move(line));
    line = {outline.back()};
  }
  if (line.size() > 1) part.lines.push_back(std::move(line));
  outline.pop_back();
  part.rings.push_back(std::move(outline));
}

MapPart shifted(const MapPart& part, double dx) {
  MapPart result = part;
  for (auto* lists : {&result.rings, &result.lines}) {
    for (std::vector<Point>& list : *lists) {
      for (Point& p : list) p.x += dx;
    }
  }
  return result;
}

/// Adds the part, and its copies a whole turn away where they reach into the window.
void add_copies(MapPart part, const MapProjection& projection, const LongitudeWindow& window,
                MapShape& shape) {
  const double period = projection.period();
  if (period > 0) {
    Extent extent;
    for (const Ring& ring : part.rings) {
      for (const Point p : ring) extent.add(p);
    }
    const double west = projection({window.west, 0}).x;
    const double east = projection({window.east(), 0}).x;
    if (extent.east > east) shape.push_back(shifted(part, -period));
    if (extent.west < west) shape.push_back(shifted(part, period));
  }
  shape.push_back(std::move(part));
}

}  // namespace

void Extent::add(Point p) {
  if (empty()) {
    *this = {p.x, p.y, p.x, p.y};
    return;
  }
  west = std::min(west, p.x);
  south = std::min(south, p.y);
  east = std::max(east, p.x);
  north = std::max(north, p.y);
}

MapShape map_shape(const MultiPolygon& shape, const MapProjection& projection,
                   const LongitudeWindow& window, double tolerance) {
  const bool geographic = projection.kind() != MapProjection::Kind::plane;
  const bool cut = geographic && cut_by_antimeridian(shape);
  const Drawer drawer(projection, tolerance);
  MapShape result;
  for (const Polygon& polygon : shape) {
    MapPart part;
    const auto add = [&](const Ring& ring) {
      DrawnRing drawn{geographic ? unwrapped(ring, window) : ring, ring.size(), geographic, cut};
      add_ring(drawn, drawer, part);
    };
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
    add_copies(std::move(part), projection, window, result);
  }
  return result;
}

bool has_lines(const std::vector<MapShape>& shapes) {
  const auto is_drawn = [](const MapPart& part) { return !part.lines.empty(); };
  return std::any_of(shapes.begin(), shapes.end(), [&](const MapShape& shape) {
    return std::any_of(shape.begin(), shape.end(), is_drawn);
  });
}

}  // namespace thiessen
