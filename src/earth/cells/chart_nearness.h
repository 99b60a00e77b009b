#pragma once

#include <optional>

#include "diagram/nearness.h"
#include "earth/sphere/geodesic.h"
#include "earth/sphere/gnomonic_chart.h"

namespace thiessen {

/// How near places are to the points of a chart by geodesic distance, as polynomials.
///
/// On the sphere the square of a chord, drawn out to the chart's plane and less what all places
/// have in common, is straight in the chart's coordinates. On the ellipsoid the sine of half the
/// geodesic's angle takes the half chord's place, and the difference, smooth and small, is told by
/// its values at the 15 Padua points of degree 4 (M. Caliari, S. De Marchi and M. Vianello,
/// Bivariate polynomial interpolation on the square at new nodal sets, 2005).
class ChartNearness {
 public:
  /// The widest part of a chart, from its centre to its sides: 32 km.
  static constexpr double widest = 0.005;

  /// For the points of a chart whose coordinates are within `reach`, at most `widest`.
  ChartNearness(const GnomonicChart& chart, double reach);

  /// The nearness of a place; nothing for one more than 3,000 km away. Accuracy: distances are
  /// right to 1e-6 metres where the reach is 12 km, 1e-5 at 25 km and 3e-5 at 32 km, for places up
  /// to three times as far. Cost: a microsecond where the place is within 70 km, else 15 geodesics.
  std::optional<Nearness> of(const EarthPoint& place) const;

 private:
  GnomonicChart chart_;
  double reach_;
  double scale_;  // metres a radian at the centre
};

}  // namespace thiessen
