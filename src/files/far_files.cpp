#include "files/far_files.h"

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "gdal/crs/transformation.h"

namespace thiessen {
namespace {

std::string range(double low, double high) {
  return low == high ? shortest_text(low) : shortest_text(low) + " to " + shortest_text(high);
}

/// Takes points from one CRS to another; those outside its area become NaN.
void take(const Crs& from, const Crs& to, std::vector<Point>& points) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<bool> inside = Transformation(from, to).apply(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!inside[i]) points[i] = {none, none};
  }
}

using Change = Point (*)(Point);

Point as_it_is(Point p) {
  return p;
}
Point swapped(Point p) {
  return {p.y, p.x};
}
Point west_for_east(Point p) {
  return {-p.x, p.y};
}
Point south_for_north(Point p) {
  return {p.x, -p.y};
}
Point times_thousand(Point p) {
  return {1000 * p.x, 1000 * p.y};
}

/// Changes the numbers that a file in the CRS `in` has, and reads them in the CRS `as`. Where that
/// cannot be done there are no points.
FarCause::Correction read_as(const Crs& study, const Crs& in, Change change, const Crs& as) {
  return [=](std::vector<Point> points) {
    try {
      take(study, in, points);
      for (Point& p : points) p = change(p);
      take(as, study, points);
    } catch (const Error&) {
      points.assign(points.size(), Point{NAN, NAN});
    }
    return points;
  };
}

/// The EPSG codes of WGS 84's UTM zones that are taken for another's: its neighbours', and those of
/// the other hemisphere. None for a CRS that is no such zone.
std::vector<std::string> zones_beside(const Crs& crs) {
  constexpr std::string_view authority = "EPSG:";
  const std::string& name = crs.name();
  if (!name.starts_with(authority)) return {};
  const Parsed<std::size_t> number = parse_size(std::string_view(name).substr(authority.size()));
  if (!number || number.value > 99'999) return {};
  const int code = static_cast<int>(number.value);
  const int zone = code % 100;
  const bool north = code / 100 == 326;
  if ((!north && code / 100 != 327) || zone < 1 || zone > 60) return {};
  std::vector<std::string> zones;
  for (const int step : {0, -1, 1, -2, 2}) {
    const int other = (zone + step + 59) % 60 + 1;
    for (const int hemisphere : {north ? 326 : 327, north ? 327 : 326}) {
      if (hemisphere * 100 + other != code)
        zones.push_back("EPSG:" + std::to_string(hemisphere * 100 + other));
    }
  }
  return zones;
}

/// The causes in one of the two files.
class CausesInFile {
 public:
  CausesInFile(std::string whose, bool of_gauges, const Crs& in, const Crs& study,
               std::vector<FarCause>& causes)
      : whose_(std::move(whose)), of_gauges_(of_gauges), in_(in), study_(study), causes_(causes) {}

  void add_of_coordinates() {
    if (in_.geographic()) {
      add(" latitude and longitude swapped", swapped);
      add(" longitudes of the other sign (west is negative)", west_for_east);
      add(" latitudes of the other sign (south is negative)", south_for_north);
    } else {
      add(" eastings and northings swapped", swapped);
      add(" coordinates in kilometres, not " + unit(), times_thousand);
      add(" eastings of the other sign", west_for_east);
      add(" northings of the other sign", south_for_north);
    }
  }
  void add_of_crs(const Crs& others) {
    if (!others.same_as(in_)) add(" coordinates in " + others.name(), as_it_is, others);
    for (const std::string& zone : zones_beside(in_))
      add(" coordinates in " + zone, as_it_is, Crs::from_text(zone, zone));
  }

 private:
  std::string unit() const { return in_.metres_per_unit() == 1 ? "metres" : "its unit"; }
  void add(const std::string& what, Change change) { add(what, change, in_); }
  void add(const std::string& what, Change change, const Crs& as) {
    FarCause cause{whose_ + what, {}, {}};
    (of_gauges_ ? cause.gauges : cause.basins) = read_as(study_, in_, change, as);
    causes_.push_back(std::move(cause));
  }

  std::string whose_;
  bool of_gauges_;
  const Crs& in_;
  const Crs& study_;
  std::vector<FarCause>& causes_;
};

}  // namespace

std::string extent_text(const Reach& reach, const Crs& crs) {
  const char* const x = crs.geographic() ? "longitude " : "x ";
  const char* const y = crs.geographic() ? ", latitude " : ", y ";
  return x + range(reach.west, reach.east) + y + range(reach.south, reach.north) + " (" +
         crs.name() + ")";
}

std::vector<FarCause> far_causes_of_files(const Crs& stations, const Crs& basins,
                                          const Crs& study) {
  std::vector<FarCause> causes;
  // What is wrong in both alike, as the order of degrees, may be in either.
  const bool alike = stations.geographic() && basins.geographic();
  CausesInFile in_stations(alike ? "the gauges' (or the basins')" : "the gauges'", true, stations,
                           study, causes);
  CausesInFile in_basins("the basins'", false, basins, study, causes);
  in_stations.add_of_coordinates();
  if (!alike) in_basins.add_of_coordinates();
  in_stations.add_of_crs(basins);
  in_basins.add_of_crs(stations);
  return causes;
}

}  // namespace thiessen
