#include "outlines/area_words.h"

#include <algorithm>
#include <cmath>

#include "base/number.h"
#include "basin/cell_clipper.h"
#include "earth/area/ellipsoid_surface.h"
#include "outlines/polygon_validity.h"

namespace thiessen {

std::string rounded_text(double value) {
  constexpr int digits = 7;
  if (value == 0) return "0";
  const int before = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  std::string text = fixed_text(value, std::clamp(digits - before, 0, 30));
  if (text.find('.') == std::string::npos) return text;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string area_words(const MultiPolygon& shape, const std::optional<CoordinateKind>& kind,
                       bool on_earth) {
  constexpr double km2 = 1e-6;
  if (on_earth)
    return rounded_text(area_of(Basin{"", shape, {}}, EllipsoidSurface()) * km2) + " km2";
  const double area = plane_area(shape);
  if (!kind || kind->geographic) return rounded_text(area);
  const double metres = kind->metres_per_unit();
  return rounded_text(area * metres * metres * km2) + " km2";
}

}  // namespace thiessen
