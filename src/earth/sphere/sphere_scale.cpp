#include "earth/sphere/sphere_scale.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/Math.hpp>
#include <cmath>
#include <numbers>

#include "earth/sphere/conformal_sphere.h"

namespace thiessen {

using GeographicLib::Math;

SphereScale::SphereScale() {
  const double a = GeographicLib::Constants::WGS84_a();
  const double e2 = GeographicLib::Constants::WGS84_f() * (2 - GeographicLib::Constants::WGS84_f());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    // Chebyshev's nodes leave out the pole itself, where the quotient below would be 0 / 0.
    const double turn = (2 * static_cast<double>(i) + 1) / (2 * static_cast<double>(nodes_.size()));
    nodes_[i] = 0.5 - 0.5 * std::cos(turn * std::numbers::pi);
    const double cosine = std::sqrt(1 - nodes_[i]);
    double sine_here = 0;
    double cosine_here = 0;
    Math::sincosd(from_sphere({cosine, 0, std::sqrt(nodes_[i])}).y, sine_here, cosine_here);
    double difference = a * cosine_here / (std::sqrt(1 - e2 * sine_here * sine_here) * cosine);
    for (std::size_t k = 0; k < i; ++k)
      difference = (difference - differences_[k]) / (nodes_[i] - nodes_[k]);
    differences_[i] = difference;
  }
}

const SphereScale& sphere_scale() {
  static const SphereScale scale;
  return scale;
}

}  // namespace thiessen
