#pragma once

#include <optional>
#include <string>

#include "geometry/polygon.h"
#include "outlines/mapping.h"

namespace thiessen {

/// A number with the digits that a reader of a message wants: seven significant ones, without an
/// exponent and without trailing zeros.
std::string rounded_text(double value);

/// The area of a valid shape in words: `12.5 km2` on the ellipsoid where `on_earth` says that the
/// coordinates are longitude and latitude in degrees, or in a plane whose unit is a length; `12.5`
/// in the square of the coordinates' unit where that is not known, or degrees. Requires outer rings
/// that run counter-clockwise.
std::string area_words(const MultiPolygon& shape, const std::optional<CoordinateKind>& kind,
                       bool on_earth);

}  // namespace thiessen
