#include "files/crs_agreement.h"

#include "files/crs_fit.h"
#include "study/coordinate_checks.h"

namespace thiessen {
namespace {

template <typename File>
void forget(File& file) {
  file.crs.reset();
  file.crs_origin = CrsOrigin::none;
}

template <typename File>
void forget_implied_unless_degrees(File& file) {
  if (file.crs_origin == CrsOrigin::implied && !reach_of(file).looks_like_degrees()) forget(file);
}

template <typename From, typename To>
void lend(const From& from, To& to, Warnings& warnings) {
  to.crs = from.crs;
  warnings.add({to.file,
                0,
                "names no CRS; that of " + from.file + ", " + from.crs->name() + ", is taken",
                {}});
}

void agree(StationsFile& stations, BasinsFile& basins, Warnings& warnings) {
  if (stations.crs && !basins.crs) {
    // WGS 84 that RFC 7946 implies is not named by anybody, so it holds for the other file only
    // where that file's coordinates may be degrees.
    const bool lent =
        stations.crs_origin != CrsOrigin::implied || reach_of(basins).looks_like_degrees();
    if (lent) {
      lend(stations, basins, warnings);
    } else {
      forget(stations);
    }
  } else if (!stations.crs && basins.crs) {
    if (basins.crs_origin == CrsOrigin::implied) {
      forget(basins);
    } else {
      lend(basins, stations, warnings);
    }
  }
}

template <typename File>
void check_fit(const File& file) {
  if (!file.crs) return;
  require_fit(file);
  if (file.crs->geographic()) require_degrees(file, file.crs->kind());
}

}  // namespace

void agree_on_crs(StationsFile& stations, BasinsFile* basins, Warnings& warnings) {
  forget_implied_unless_degrees(stations);
  if (basins != nullptr) {
    forget_implied_unless_degrees(*basins);
    agree(stations, *basins, warnings);
    check_fit(*basins);
  }
  check_fit(stations);
}

}  // namespace thiessen
