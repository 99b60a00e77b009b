#include "files/places/crs_agreement.h"

#include "files/places/crs_fit.h"
#include "study/coordinate_checks.h"

namespace thiessen {
namespace {

template <typename File>
void forget(File& file) {
  file.crs.reset();
  file.crs_origin = CrsOrigin::none;
}

template <typename File>
void forget_implied_unless_degrees(File& file, Asked asked) {
  if (file.crs_origin != CrsOrigin::implied) return;
  const Reach reach = reach_of(file);
  const bool plane = asked == Asked::plane ? reach.not_degrees > 0 : !reach.looks_like_degrees();
  if (plane) forget(file);
}

/// Two files of one plane: a GeoJSON of which only some numbers could be degrees, beside a file
/// that names no CRS.
template <typename File, typename Other>
void forget_implied_beside_plane(File& file, const Other& other, Warnings& warnings) {
  if (file.crs_origin != CrsOrigin::implied || other.crs) return;
  const Reach reach = reach_of(file);
  if (reach.not_degrees == 0) return;
  forget(file);
  warnings.add({file.file, 0,
                "not all of its coordinates can be longitude and latitude, so they are taken as a "
                "plane: " +
                    reach.sentence(),
                setting("metric", "planar") + " says that they are one"});
}

std::string name_of(const Crs& crs) {
  return crs.is_wgs84() ? crs.name() + " (WGS 84)" : crs.name();
}

template <typename From, typename To>
void lend(const From& from, To& to, Warnings& warnings) {
  to.crs = from.crs;
  to.crs_origin = CrsOrigin::lent;
  require_fit(to, from.file);
  warnings.add({to.file,
                0,
                "names no CRS; that of " + from.file + ", " + name_of(*from.crs) + ", is taken",
                {}});
}

void agree(StationsFile& stations, BasinsFile& basins, Asked asked, Warnings& warnings) {
  forget_implied_unless_degrees(basins, asked);
  if (asked == Asked::nothing) {
    forget_implied_beside_plane(stations, basins, warnings);
    forget_implied_beside_plane(basins, stations, warnings);
  }
  if (basins.crs) require_fit(basins, {});
  if (stations.crs) require_fit(stations, {});
  if (stations.crs && !basins.crs) {
    lend(stations, basins, warnings);
  } else if (!stations.crs && basins.crs) {
    lend(basins, stations, warnings);
  }
}

void warn_of_assumed_plane(const StationsFile& stations, const BasinsFile* basins,
                           Warnings& warnings) {
  if (reach_of(stations).not_degrees > 0) return;
  if (basins != nullptr && reach_of(*basins).not_degrees > 0) return;
  const std::string none = basins == nullptr ? "" : ", and neither does " + basins->file;
  warnings.add({stations.file, 0,
                "names no CRS" + none +
                    ": the coordinates are taken as a plane, though they could be degrees",
                setting("crs", "EPSG:4326") + " if they are longitude and latitude, " +
                    setting("metric", "planar") + " if they are a plane's"});
}

}  // namespace

void agree_on_crs(StationsFile& stations, BasinsFile* basins, Asked asked, Warnings& warnings) {
  forget_implied_unless_degrees(stations, asked);
  if (basins != nullptr) {
    agree(stations, *basins, asked, warnings);
  } else if (stations.crs) {
    require_fit(stations, {});
  }
  if (!stations.crs && asked == Asked::nothing) warn_of_assumed_plane(stations, basins, warnings);
}

}  // namespace thiessen
