#include "map/ink/dashes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace thiessen {
namespace {

/// The lengths along a line at which its points lie.
std::vector<double> lengths_along(std::span<const Point> points) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    lengths.push_back(lengths.back() +
                      std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y));
  }
  return lengths;
}

}  // namespace

std::vector<Dash> dashes(double length, double dash, double gap) {
  if (length <= gap) return {{0, length}};
  const double gaps = std::max(1.0, std::round((length - dash) / (dash + gap)));
  const double stretch = length / (gaps * (dash + gap) + dash);
  std::vector<Dash> result;
  for (double i = 0; i <= gaps; ++i) {
    const double from = i * (dash + gap) * stretch;
    result.push_back({from, i == gaps ? length : from + dash * stretch});
  }
  return result;
}

std::vector<std::vector<Point>> dashed(std::span<const Point> points, double dash, double gap) {
  const std::vector<double> lengths = lengths_along(points);
  if (points.size() < 2 || lengths.back() == 0) return {};
  const auto after = [&](double length) {
    const auto next = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
    return static_cast<std::size_t>(next - lengths.begin());
  };
  const auto at = [&](double length) {
    const std::size_t i = after(length);
    const double side = lengths[i] - lengths[i - 1];
    const double share = side > 0 ? (length - lengths[i - 1]) / side : 0;
    return Point{points[i - 1].x + share * (points[i].x - points[i - 1].x),
                 points[i - 1].y + share * (points[i].y - points[i - 1].y)};
  };
  std::vector<std::vector<Point>> result;
  for (const Dash& d : dashes(lengths.back(), dash, gap)) {
    std::vector<Point> line{at(d.from)};
    for (std::size_t i = after(d.from); i < after(d.to); ++i) line.push_back(points[i]);
    line.push_back(at(d.to));
    result.push_back(std::move(line));
  }
  return result;
}

}  // namespace thiessen
