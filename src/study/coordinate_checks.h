#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "base/error.h"
#include "geometry/point.h"
#include "outlines/mapping.h"
#include "study/source_lists.h"

namespace thiessen {

/// How far coordinates reach.
struct Reach {
  double west = 0;
  double south = 0;
  double east = 0;
  double north = 0;
  std::size_t points = 0;
  std::size_t not_degrees = 0;  ///< those that cannot be longitude and latitude

  void see(Point point);
  /// Most of the points may be longitude and latitude.
  bool looks_like_degrees() const { return 2 * not_degrees <= points; }
  /// `x from 3.5 to 9 and y from 40 to 41`
  std::string sentence() const;
};

Reach reach_of(const StationList& stations);
Reach reach_of(const BasinList& basins);

/// Each station's latitude lies in [-90, 90] and its longitude in [-540, 540]. For a
/// geographic kind. Throws Error with every station that is not so, with a hint where the two look
/// swapped.
void require_degrees(const StationList& stations, const CoordinateKind& kind);
/// The same for the basins: the first such point of each.
void require_degrees(const BasinList& basins, const CoordinateKind& kind);

/// Takes longitudes beyond 180 degrees round the Earth, with one warning. For a geographic kind.
void turn_longitudes(StationList& stations, const CoordinateKind& kind, Warnings& warnings);

/// The longitudes of a plane of degrees, where distances do not go round the Earth: those that run
/// from -180 to 180 must not stand beside others from 0 to 360.
class LongitudeRange {
 public:
  /// `whose` is `station 'X'` or the like.
  void see(double longitude, const std::string& whose, const std::string& file, std::size_t line);
  /// Throws Error where both kinds were seen, naming the two that are farthest apart.
  void require_one_turn() const;

 private:
  struct Extreme {
    double longitude = std::numeric_limits<double>::quiet_NaN();
    std::string whose;
    std::string file;
    std::size_t line = 0;
  };
  Extreme west_;
  Extreme east_;
};

}  // namespace thiessen
