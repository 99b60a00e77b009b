#include "map/sheet/study_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/interrupt.h"

namespace thiessen {
namespace {

constexpr double radian = std::numbers::pi / 180;
/// The largest distance from its centre, in degrees, at which the stereographic projection is used:
/// its scale there is 1.6 times that at the centre.
constexpr double stereographic_reach = 75;

[[noreturn]] void reject(const char* text) {
  throw Error(Message{{}, 0, text, {}});
}

template <typename Visit>
void for_each_ring(const MultiPolygon& shape, const Visit& visit) {
  throw_if_interrupted();
  for (const Polygon& polygon : shape) {
    visit(polygon.outer);
    for (const Ring& hole : polygon.holes) visit(hole);
  }
}

template <typename Visit>
void for_each_ring(const Picture& picture, const Visit& visit) {
  for (const PictureCell& cell : picture.cells) for_each_ring(cell.shape, visit);
  for (const PictureBasin& basin : picture.basins) for_each_ring(basin.shape, visit);
}

/// The box of all shapes in the study's coordinates, or of the gauges where there are no shapes.
Extent study_box(const Picture& picture, const LongitudeWindow& window) {
  Extent box;
  for_each_ring(picture, [&](const Ring& ring) {
    for (const Point p : ring) box.add({picture.geographic ? window.place(p.x) : p.x, p.y});
  });
  if (!box.empty()) return box;
  for (const PictureGauge& gauge : picture.gauges) {
    const Point p = gauge.position;
    box.add({picture.geographic ? window.place(p.x) : p.x, p.y});
  }
  return box.empty() ? Extent{0, 0, 0, 0} : box;
}

void require_finite(const Picture& picture) {
  const auto check = [](Point p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) reject("a coordinate to draw is not finite");
  };
  for_each_ring(picture, [&](const Ring& ring) { std::for_each(ring.begin(), ring.end(), check); });
  for (const PictureGauge& gauge : picture.gauges) check(gauge.position);
}

LongitudeWindow longitude_window(const Picture& picture) {
  LongitudeCensus census;
  bool any = false;
  for_each_ring(picture, [&](const Ring& ring) {
    census.add(ring);
    any = any || !ring.empty();
  });
  if (!any) {
    for (const PictureGauge& gauge : picture.gauges) census.add(gauge.position.x);
  }
  return census.window();
}

/// The largest distance of a vertex from `centre`, in degrees.
double reach(const Picture& picture, Point centre) {
  double farthest = 0;
  for_each_ring(picture, [&](const Ring& ring) {
    for (const Point p : ring) farthest = std::max(farthest, angular_distance(centre, p));
  });
  return farthest;
}

/// The place of the map's centre: a pole for a study that winds round it.
Point centre_of(const Extent& box, const LongitudeWindow& window) {
  const double half_turn = 180;
  if (window.span > half_turn && box.south > 0) return {0, 90};
  if (window.span > half_turn && box.north < 0) return {0, -90};
  return {window.middle(), (box.south + box.north) / 2};
}

void project_geographic(const Picture& picture, StudyView& view) {
  view.window = longitude_window(picture);
  const Extent box = study_box(picture, view.window);
  const Point centre = centre_of(box, view.window);
  const double degrees = reach(picture, centre);
  view.radius = degrees * radian;
  if (degrees <= stereographic_reach) {
    view.projection = MapProjection::stereographic(centre);
    return;
  }
  const double middle = (box.south + box.north) / 2;
  view.projection = MapProjection::plate_carree(view.window, middle);
}

void project_plane(const Picture& picture, StudyView& view) {
  const Extent box = study_box(picture, view.window);
  const double farthest = 1e150;
  for (const double side : {box.west, box.south, box.east, box.north}) {
    if (std::abs(side) > farthest) reject("the study area reaches too far to be drawn");
  }
  const Point centre{(box.west + box.east) / 2, (box.south + box.north) / 2};
  view.projection = MapProjection::plane(centre, picture.metres_per_unit);
}

void add(const std::vector<MapShape>& shapes, Extent& extent) {
  for (const MapShape& shape : shapes) {
    throw_if_interrupted();
    for (const MapPart& part : shape) {
      for (const Ring& ring : part.rings) {
        for (const Point p : ring) extent.add(p);
      }
    }
  }
}

/// Grows the extent to hold the gauges that own cells and lie near enough.
void add_owners(const Picture& picture, const std::vector<Point>& gauges, Extent& extent) {
  constexpr double nearness = 0.25;  // share of the extent's larger side
  const Extent shapes = extent;
  const double margin = nearness * std::max(shapes.width(), shapes.height());
  for (const PictureCell& cell : picture.cells) {
    if (cell.gauge >= gauges.size()) continue;
    const Point p = gauges[cell.gauge];
    const bool near = p.x >= shapes.west - margin && p.x <= shapes.east + margin &&
                      p.y >= shapes.south - margin && p.y <= shapes.north + margin;
    if (near) extent.add(p);
  }
}

/// The extent to show: the whole window where the map repeats, else all shapes and their gauges.
Extent sight(const Picture& picture, const StudyView& view) {
  Extent extent;
  add(view.cells, extent);
  add(view.basins, extent);
  if (extent.empty()) {
    for (const Point p : view.gauges) extent.add(p);
  } else if (view.projection.period() == 0) {
    add_owners(picture, view.gauges, extent);
  }
  if (extent.empty()) extent.add({0, 0});
  if (view.projection.period() > 0) {
    extent.west = view.projection({view.window.west, 0}).x;
    extent.east = view.projection({view.window.east(), 0}).x;
  }
  if (extent.width() > 0 || extent.height() > 0) return extent;
  const double side = view.projection.kind() == MapProjection::Kind::plane ? 0.5 : 1e-4;
  return {extent.west - side, extent.south - side, extent.east + side, extent.north + side};
}

/// The lines on the map's plane. Where the map repeats they are parted at its sides.
std::vector<std::vector<Point>> projected(const std::vector<std::vector<Point>>& lines,
                                          bool geographic, const StudyView& view) {
  constexpr double half_turn = 180;
  std::vector<std::vector<Point>> result;
  for (const std::vector<Point>& line : lines) {
    std::vector<Point>* part = &result.emplace_back();
    double before = 0;
    for (const Point p : line) {
      const double x = geographic ? view.window.place(p.x) : p.x;
      const bool jumps = geographic && !part->empty() && std::abs(x - before) > half_turn;
      if (jumps) part = &result.emplace_back();
      part->push_back(view.projection({x, p.y}));
      before = x;
    }
  }
  return result;
}

/// Projects all shapes, and finds the extent.
void project_shapes(const Picture& picture, StudyView& view) {
  constexpr double finest = 5e-5;  // share of the study's radius: half a pixel in 20,000
  const double tolerance = finest * std::max(view.radius, 1e-12);
  const auto shape = [&](const MultiPolygon& polygons) {
    throw_if_interrupted();
    return map_shape(polygons, view.projection, view.window, tolerance);
  };
  for (const PictureCell& cell : picture.cells) view.cells.push_back(shape(cell.shape));
  for (const PictureBand& band : picture.bands) view.bands.push_back(shape(band.shape));
  for (const PictureBasin& basin : picture.basins) view.basins.push_back(shape(basin.shape));
  for (const PictureIsohyet& isohyet : picture.isohyets)
    view.isohyets.push_back(projected(isohyet.lines, picture.geographic, view));
  for (const PictureGauge& gauge : picture.gauges) {
    const Point p = gauge.position;
    const double x = picture.geographic ? view.window.place(p.x) : p.x;
    view.gauges.push_back(view.projection({x, p.y}));
  }
  view.extent = sight(picture, view);
}

}  // namespace

StudyView view_study(const Picture& picture) {
  require_finite(picture);
  StudyView view;
  picture.geographic ? project_geographic(picture, view) : project_plane(picture, view);
  project_shapes(picture, view);
  return view;
}

StudyView view_study(const Picture& picture, const StudyView& other) {
  require_finite(picture);
  StudyView view;
  view.projection = other.projection;
  view.window = other.window;
  view.radius = other.radius;
  project_shapes(picture, view);
  return view;
}

}  // namespace thiessen
