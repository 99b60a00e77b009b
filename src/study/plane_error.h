#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "rainfall/network/weights.h"
#include "study/study.h"

namespace thiessen {

/// What a plane does to a study: how far its weights and areas are from those that the shortest
/// paths on the Earth give.
struct PlaneError {
  /// A gauge's weight in the plane and on the Earth.
  struct Change {
    std::size_t basin = 0;
    StationIndex station{0};
    double in_plane = 0;
    double on_earth = 0;
    double size() const { return in_plane > on_earth ? in_plane - on_earth : on_earth - in_plane; }
  };
  /// A basin's area in the plane, as a multiple of that on the Earth.
  struct AreaFactor {
    std::size_t basin = 0;
    double factor = 1;
  };

  Change worst_change;
  /// The factor that is farthest from 1; nothing where the plane's unit is not a length.
  std::optional<AreaFactor> worst_area;

  /// The change of a weight from which on a plane is warned of.
  static constexpr double change_to_warn_of = 1e-3;
  /// The share of an area by which it may be off without a warning.
  static constexpr double area_to_warn_of = 1e-2;
  bool moves_weights() const { return worst_change.size() > change_to_warn_of; }
  bool distorts_areas() const;
};

/// Compares the weights of a plane with those on the Earth. Both have an entry a basin, and
/// stations in rising order. Among equal changes the first counts. Cost: linear in the weights.
PlaneError error_of_plane(std::span<const BasinWeights> in_plane,
                          std::span<const BasinWeights> on_earth, bool areas_in_metres);

/// Weighs a study in its plane and on the Earth, and compares. `on_earth` holds the same stations
/// and basins in longitude and latitude, in the same order; it is used up. Cost: a planar and a
/// geodesic weighing.
PlaneError error_of_plane(const Study& study, StudyParts on_earth, unsigned threads);

/// Words the error for a message: which weight changes most, and how areas do.
std::string sentence_of(const PlaneError& error, const Study& study);

}  // namespace thiessen
