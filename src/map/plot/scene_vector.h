#pragma once

#include <cmath>

#include "geometry/coordinates.h"

namespace thiessen {

/// A place or a step in the SceneCoordinates of a scene in space.
using SceneVector = CoordinatesIn<3>;

inline SceneVector operator+(const SceneVector& a, const SceneVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline SceneVector operator-(const SceneVector& a, const SceneVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline SceneVector operator*(double factor, const SceneVector& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
inline double dot(const SceneVector& a, const SceneVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline SceneVector cross(const SceneVector& a, const SceneVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const SceneVector& a) {
  return std::hypot(a[0], a[1], a[2]);
}
/// The vector of length 1 in the direction of `a`. Requires that `a` is not 0.
inline SceneVector unit(const SceneVector& a) {
  return (1 / length(a)) * a;
}

}  // namespace thiessen
