#include "gdal/crs/unknown_datum.h"

#include <cmath>
#include <string_view>

#include "base/error.h"
#include "base/utf8.h"
#include "gdal/crs/crs_definition.h"
#include "gdal/crs/spheres.h"

namespace thiessen {
namespace {

bool on_modern_ellipsoid(const Crs& crs) {
  const OGRSpatialReference& system = crs.definition().system;
  return std::abs(system.GetSemiMajor() - 6378137) < 0.5 &&
         std::abs(system.GetInvFlattening() - 298.25722) < 1e-4;
}

bool may_stay(const Crs& crs) {
  return on_sphere(crs) || on_modern_ellipsoid(crs);
}

/// Whether a CRS names an ellipsoid but no datum, as `+ellps=bessel` and EPSG:4004 do.
bool unnamed_datum(const Crs& crs) {
  const char* name = crs.definition().system.GetAttrValue("DATUM");
  const std::string lower = name == nullptr ? "" : lower_case(name);
  return lower.empty() || lower.starts_with("unknown") || lower.starts_with("unspecified") ||
         lower.starts_with("not_specified") || lower.starts_with("not specified");
}

bool same_ellipsoid(const Crs& a, const Crs& b) {
  const OGRSpatialReference& one = a.definition().system;
  const OGRSpatialReference& other = b.definition().system;
  return one.GetSemiMajor() == other.GetSemiMajor() &&
         one.GetInvFlattening() == other.GetInvFlattening();
}

std::string ellipsoid_of(const Crs& crs) {
  const char* name = crs.definition().system.GetAttrValue("SPHEROID");
  return name == nullptr || std::string_view(name) == "unknown" ? "its ellipsoid" : name;
}

std::string way_between(const Crs& from, const Crs& to) {
  return "from " + printable(from.name()) + " to " + printable(to.name());
}

}  // namespace

bool on_sphere(const Crs& crs) {
  return is_on_sphere(crs.definition().system);
}

bool may_be_taken_over(const Crs& from, const Crs& to) {
  if (unnamed_datum(from) && unnamed_datum(to) && same_ellipsoid(from, to)) return true;
  return may_stay(from) && may_stay(to);
}

void fail_for_grid(const Crs& from, const Crs& to, const std::string& grid) {
  throw Error(Message{{},
                      0,
                      "no transformation of datum " + way_between(from, to) +
                          " can be had: PROJ lacks the grid " + quoted(grid, 80),
                      "the packages proj-data and proj-datumgrid, or projsync, bring grids"});
}

void fail_for_projection(const Crs& from, const Crs& to) {
  throw Error(Message{
      {}, 0, "PROJ cannot transform " + way_between(from, to) + ": it lacks the projection", {}});
}

void fail_for_datum(const Crs& from, const Crs& to) {
  const Crs& odd = may_stay(from) ? to : from;
  throw Error(Message{
      {},
      0,
      "no transformation of datum " + way_between(from, to) + " is known: coordinates on " +
          quoted(ellipsoid_of(odd), 60) + " without a known datum may be hundreds of metres off",
      "name a CRS whose datum is known; " + setting("metric", "planar") + ", or " +
          setting("plane") + " with a projected CRS of the same datum, needs no datum"});
}

}  // namespace thiessen
