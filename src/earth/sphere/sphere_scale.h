#pragma once

#include <array>
#include <cstddef>

namespace thiessen {

/// The scale of the conformal map, metres on the ellipsoid for a radian on the sphere, as a
/// polynomial in the square of the sine of the conformal latitude, by Newton's interpolation.
/// Accuracy: 1e-13 of it.
class SphereScale {
 public:
  SphereScale();

  /// The scale at directions whose z is `sine`.
  double at(double sine) const {
    const double square = sine * sine;
    double scale = 0;
    for (std::size_t i = nodes_.size(); i-- > 0;)
      scale = differences_[i] + (square - nodes_[i]) * scale;
    return scale;
  }

 private:
  std::array<double, 7> nodes_{};
  std::array<double, 7> differences_{};
};

/// The scale of the conformal map; scale_on_earth looks it up.
const SphereScale& sphere_scale();

}  // namespace thiessen
