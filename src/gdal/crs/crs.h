#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/wording.h"
#include "geometry/box.h"
#include "geometry/point.h"
#include "outlines/mapping.h"

namespace thiessen {

/// A coordinate reference system on the Earth, geographic or projected. Coordinates are always in
/// the traditional order of GIS (longitude before latitude, easting before northing), whatever
/// order its authority states. Copies are cheap and share the definition.
class Crs {
 public:
  /// Reads a CRS from `EPSG:32633` or another authority's code, from WKT or from PROJ's notation.
  /// Opens no file and no connection. Throws Error, naming `subject`, where the text is none of
  /// these, is longer than 64 KiB, is unknown, is a pipeline, is of another body than the Earth, or
  /// is neither geographic nor projected.
  static Crs from_text(std::string_view text, const Wording& subject);
  static Crs wgs84();

  /// The definition as WKT 2 (2019).
  const std::string& wkt() const;
  /// The name for messages: `EPSG:32633`, or the CRS's own name where it has no code.
  const std::string& name() const;
  /// The kind of its coordinates: degrees or lengths, and their unit.
  CoordinateKind kind() const;
  /// Whether it is geographic: its coordinates are longitude and latitude, rather than easting and
  /// northing.
  bool geographic() const;
  /// Whether it is WGS 84 longitude and latitude in degrees.
  bool is_wgs84() const;
  /// Degrees in the unit of a geographic CRS; 0 for a projected one.
  double degrees_per_unit() const;
  /// Metres in the unit of a projected CRS; 0 for a geographic one.
  double metres_per_unit() const;
  /// Returns this CRS for use in an area, given in degrees of WGS 84, whose east may lie beyond
  /// 180. The operation between its datum and another's is then the one for this area.
  Crs over(const Box& area) const;
  const std::optional<Box>& area() const { return area_; }
  /// Whether both CRSs place the same coordinates at the same points; names and axis order do not
  /// count.
  bool same_as(const Crs& other) const;

  struct Definition;
  explicit Crs(std::shared_ptr<const Definition> definition) : definition_(std::move(definition)) {}
  const Definition& definition() const { return *definition_; }

 private:
  std::shared_ptr<const Definition> definition_;
  std::optional<Box> area_;
};

}  // namespace thiessen
