#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/box.h"
#include "geometry/point.h"

namespace thiessen {

/// A coordinate reference system on the Earth, geographic or projected. Coordinates are always in
/// the traditional order of GIS (longitude before latitude, easting before northing), whatever
/// order its authority states. Copies are cheap and share the definition.
class Crs {
 public:
  /// From `EPSG:32633` or another authority's code, WKT or PROJ. Opens no file and no connection.
  /// Throws Error, naming `option`, where the text is none of these, is longer than 64 KiB, is
  /// unknown, is a pipeline, is of another body than the Earth, or is neither geographic nor
  /// projected.
  static Crs from_text(std::string_view text, std::string_view option);
  static Crs wgs84();

  /// WKT 2 (2019).
  const std::string& wkt() const;
  /// `EPSG:32633`, or the CRS's name where it has no code; for messages.
  const std::string& name() const;
  /// Longitude and latitude in degrees, and not easting and northing.
  bool geographic() const;
  /// WGS 84 longitude and latitude in degrees.
  bool is_wgs84() const;
  /// How many degrees the unit of a geographic CRS holds; 0 for a projected one.
  double degrees_per_unit() const;
  /// How long the unit of a projected CRS is in metres; 0 for a geographic one.
  double metres_per_unit() const;
  /// The same CRS, used in this area: degrees of WGS 84, east possibly beyond 180. The operation
  /// between its datum and another's is then the one for this area.
  Crs over(const Box& area) const;
  const std::optional<Box>& area() const { return area_; }
  /// Whether both place the same coordinates at the same points; names and axis order do not count.
  bool same_as(const Crs& other) const;

  struct Definition;
  explicit Crs(std::shared_ptr<const Definition> definition) : definition_(std::move(definition)) {}
  const Definition& definition() const { return *definition_; }

 private:
  std::shared_ptr<const Definition> definition_;
  std::optional<Box> area_;
};

class CoordinateOperation;

/// Takes points from one CRS to another, vertex by vertex, by one operation for all (see
/// CoordinateOperation): the best for the area over which either CRS is used.
/// Every answer is proved: a point lies outside the projection's area where the way back misses it
/// by more than 0.1 m (within the area it misses by less than 1 mm), or where it is further than 20
/// degrees from the area for which the CRS is made: projections give finite nonsense there. Not
/// safe for two threads at once.
class Transformation {
 public:
  /// Throws Error where no transformation of datum is known, naming both.
  Transformation(const Crs& from, const Crs& to);
  ~Transformation();
  Transformation(Transformation&&) noexcept;
  Transformation& operator=(Transformation&&) noexcept;

  /// Nothing where the point lies outside the projection's area. Cost: up to four projections.
  std::optional<Point> operator()(Point point) const;
  /// All of them in place; the flag is false for each that lies outside the projection's area, and
  /// its point is then not changed.
  std::vector<bool> apply(std::vector<Point>& points) const;
  /// The same without the way back: for points that are known to lie inside the area. A point that
  /// cannot be transformed becomes NaN.
  void apply_unproved(std::vector<Point>& points) const;
  /// The same CRS on both sides: points stay as they are, bit for bit.
  bool identity() const;
  /// What takes the points; null for the same CRS on both sides.
  const CoordinateOperation* operation() const;

 private:
  struct Proj;
  std::unique_ptr<Proj> proj_;
};

}  // namespace thiessen
