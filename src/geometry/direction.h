#pragma once

#include <cmath>

namespace thiessen {

/// A vector in space; a unit vector is a point of the sphere.
struct Direction {
  double x = 0;
  double y = 0;
  double z = 0;

  friend Direction operator+(Direction a, Direction b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Direction operator-(Direction a, Direction b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Direction operator*(double s, Direction a) { return {s * a.x, s * a.y, s * a.z}; }
};

inline double dot(Direction a, Direction b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Direction cross(Direction a, Direction b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Direction a) {
  return std::sqrt(dot(a, a));
}
/// The vector of length 1 that points the same way. Requires one other than zero.
inline Direction unit(Direction a) {
  return (1 / length(a)) * a;
}

}  // namespace thiessen
