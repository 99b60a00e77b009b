#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "earth/yardstick.h"
#include "geometry/point.h"
#include "rainfall/network/station_index.h"
#include "tessellation/place.h"

namespace thiessen {

/// A rain gauge.
struct Station {
  std::string id;
  Point position;  ///< in the study's coordinates: WGS 84 longitude and latitude, or the plane's
  std::size_t line = 0;  ///< in its file, from 1: the line (CSV) or the feature's number
};

/// The gauges of a study and the places they stand at. Stations of equal coordinates share a place.
/// Equal are also 0 and -0, longitudes of 180 and -180 degrees, and all longitudes at a pole. On
/// the Earth stations within a micrometre of each other share one too, and all that a chain of such
/// pairs joins; the place is then where the least of them by longitude and latitude stands. Places
/// are numbered in the order of their first stations. Cost: n log n.
class Network {
 public:
  /// Requires coordinates in the exact range of predicates.h.
  Network(std::vector<Station> stations, Metric metric);

  const std::vector<Station>& stations() const { return stations_; }
  const std::vector<Point>& places() const { return places_; }
  PlaceIndex place_of(StationIndex station) const { return place_of_[index(station)]; }
  /// The stations at a place, in the order of their file.
  std::span<const StationIndex> stations_at(PlaceIndex place) const;

 private:
  std::vector<Station> stations_;
  std::vector<Point> places_;
  std::vector<PlaceIndex> place_of_;
  std::vector<std::size_t> first_at_;  // by place: where its stations begin in by_place_
  std::vector<StationIndex> by_place_;
};

}  // namespace thiessen
