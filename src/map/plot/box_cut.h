#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/coordinates.h"

namespace thiessen {

template <int Dimension>
struct Line {
  CoordinatesIn<Dimension> anchor;
  CoordinatesIn<Dimension> direction;

  CoordinatesIn<Dimension> at(double t) const {
    CoordinatesIn<Dimension> place = anchor;
    for (std::size_t i = 0; i < place.size(); ++i) place[i] += t * direction[i];
    return place;
  }
};

/// A range of a line's parameter; the whole line at first.
struct Stretch {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// Cuts a stretch of a line to the box about 0 that has these half sides. None where no point of
/// the stretch lies in the box.
template <int Dimension>
std::optional<Stretch> cut_to_box(const Line<Dimension>& line, Stretch stretch,
                                  const CoordinatesIn<Dimension>& half) {
  for (std::size_t i = 0; i < half.size(); ++i) {
    const double start = line.anchor[i];
    const double step = line.direction[i];
    if (step == 0) {
      if (std::abs(start) > half[i]) return std::nullopt;
      continue;
    }
    double enter = (-half[i] - start) / step;
    double leave = (half[i] - start) / step;
    if (enter > leave) std::swap(enter, leave);
    stretch = {std::max(stretch.from, enter), std::min(stretch.to, leave)};
  }
  if (!(stretch.from <= stretch.to)) return std::nullopt;
  return stretch;
}

template <int Dimension>
bool is_in_box(const CoordinatesIn<Dimension>& place, const CoordinatesIn<Dimension>& half) {
  for (std::size_t i = 0; i < half.size(); ++i) {
    if (!(std::abs(place[i]) <= half[i])) return false;
  }
  return true;
}

/// Cuts a convex polygon in space to the box (Sutherland and Hodgman); empty where it lies outside.
std::vector<CoordinatesIn<3>> cut_to_box(std::vector<CoordinatesIn<3>> polygon,
                                         const CoordinatesIn<3>& half);

}  // namespace thiessen
