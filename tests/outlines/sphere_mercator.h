#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "outlines/mapping.h"

namespace thiessen {

/// Mercator's projection of a sphere of 6,371 km, in closed form, between 85 degrees south and
/// north: a mapping for tests that needs no library of projections.
struct SphereMercator {
  static constexpr double radius = 6371000;
  static constexpr double radian = std::numbers::pi / 180;
  static constexpr double farthest = 85;

  static Point plane(Point degrees) {
    return {radius * radian * degrees.x, radius * std::atanh(std::sin(radian * degrees.y))};
  }
  static Point degrees(Point plane) {
    return {plane.x / radius / radian, std::asin(std::tanh(plane.y / radius)) / radian};
  }
};

/// From degrees to the plane.
class ToMercator : public Mapping {
 public:
  CoordinateKind from() const override { return {true, 1}; }
  CoordinateKind to() const override { return {false, 1}; }
  bool identity() const override { return false; }
  std::vector<bool> apply(std::vector<Point>& points) const override {
    std::vector<bool> inside;
    for (Point& point : points) {
      inside.push_back(std::abs(point.y) <= SphereMercator::farthest);
      if (inside.back()) point = SphereMercator::plane(point);
    }
    return inside;
  }
  void apply_unproved(std::vector<Point>& points) const override {
    for (Point& point : points) {
      const double nan = std::numeric_limits<double>::quiet_NaN();
      point = std::abs(point.y) <= SphereMercator::farthest ? SphereMercator::plane(point)
                                                            : Point{nan, nan};
    }
  }
};

/// From the plane to degrees; what leads beyond the half turn runs on.
class FromMercator : public Mapping {
 public:
  CoordinateKind from() const override { return {false, 1}; }
  CoordinateKind to() const override { return {true, 1}; }
  bool identity() const override { return false; }
  std::vector<bool> apply(std::vector<Point>& points) const override {
    apply_unproved(points);
    return std::vector<bool>(points.size(), true);
  }
  void apply_unproved(std::vector<Point>& points) const override {
    for (Point& point : points) point = SphereMercator::degrees(point);
  }
};

}  // namespace thiessen
