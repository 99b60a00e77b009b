#include "map/ink/contrast.h"

#include <algorithm>
#include <cmath>

namespace thiessen {
namespace {

constexpr double whole = 255;

double linear(std::uint8_t channel) {
  const double share = channel / whole;
  return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

double luminance(Colour c) {
  return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

}  // namespace

Colour blended(Colour ground, Colour ink, int alpha) {
  const auto mix = [&](std::uint8_t below, std::uint8_t above) {
    return static_cast<std::uint8_t>(std::lround(below + (above - below) * alpha / whole));
  };
  return {mix(ground.red, ink.red), mix(ground.green, ink.green), mix(ground.blue, ink.blue)};
}

double contrast(Colour a, Colour b) {
  constexpr double flare = 0.05;  // light that even black sends back
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + flare) / (dark + flare);
}

}  // namespace thiessen
