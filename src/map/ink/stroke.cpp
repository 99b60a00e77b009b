#include "map/ink/stroke.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace thiessen {
namespace {

struct Segment {
  Point from;
  Point to;
};

/// Narrows the range [low, high] of the line's parameter t to where start + t * step lies in [min,
/// max].
void clip_range(double start, double step, double min, double max, double& low, double& high) {
  if (step == 0) {
    if (start < min || start > max) high = -1;
    return;
  }
  const double enter = ((step > 0 ? min : max) - start) / step;
  const double leave = ((step > 0 ? max : min) - start) / step;
  low = std::max(low, enter);
  high = std::min(high, leave);
}

/// The part of a segment that lies within `reach` of the layer.
std::optional<Segment> clipped(const Coverage& layer, const Segment& s, double reach) {
  const Point step{s.to.x - s.from.x, s.to.y - s.from.y};
  double low = 0;
  double high = 1;
  clip_range(s.from.x, step.x, -reach, layer.width + reach, low, high);
  clip_range(s.from.y, step.y, -reach, layer.height + reach, low, high);
  if (low > high) return std::nullopt;
  const auto at = [&](double t) { return Point{s.from.x + t * step.x, s.from.y + t * step.y}; };
  return Segment{low == 0 ? s.from : at(low), high == 1 ? s.to : at(high)};
}

double distance(const Segment& s, Point p) {
  const Point step{s.to.x - s.from.x, s.to.y - s.from.y};
  const double square = step.x * step.x + step.y * step.y;
  const double along = (p.x - s.from.x) * step.x + (p.y - s.from.y) * step.y;
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - s.from.x - t * step.x, p.y - s.from.y - t * step.y);
}

/// The range of x that can lie within `reach` of the segment at height `y`.
std::pair<double, double> span_at(const Segment& s, double y, double reach) {
  double low = std::min(s.from.x, s.to.x) - reach;
  double high = std::max(s.from.x, s.to.x) + reach;
  const double rise = s.to.y - s.from.y;
  if (rise != 0) {
    const double run = s.to.x - s.from.x;
    const double middle = s.from.x + (y - s.from.y) * run / rise;
    const double side = reach * std::hypot(run, rise) / std::abs(rise);
    low = std::max(low, middle - side);
    high = std::min(high, middle + side);
  }
  return {low, high};
}

}  // namespace

void stroke(Coverage& layer, Point from, Point to, double line_width) {
  const double half = line_width / 2;
  const double reach = half + 1;
  const auto segment = clipped(layer, {from, to}, reach);
  if (!segment) return;
  const auto pixel = [](double position, int size) {
    return static_cast<int>(std::clamp(std::floor(position), 0.0, size - 1.0));
  };
  const int top = pixel(std::min(segment->from.y, segment->to.y) - reach, layer.height);
  const int bottom = pixel(std::max(segment->from.y, segment->to.y) + reach, layer.height);
  for (int row = top; row <= bottom; ++row) {
    const auto [low, high] = span_at(*segment, row + 0.5, reach);
    if (high < 0 || low > layer.width) continue;
    for (int x = pixel(low, layer.width); x <= pixel(high, layer.width); ++x) {
      const double inside = half + 0.5 - distance(*segment, {x + 0.5, row + 0.5});
      if (inside <= 0) continue;
      const double share = std::min({inside, 1.0, line_width});
      std::uint8_t& covered = layer.at(x, row);
      covered = std::max(covered, static_cast<std::uint8_t>(std::lround(255 * share)));
    }
  }
}

void stroke(Coverage& layer, std::span<const Point> points, double line_width) {
  constexpr double shortest = 1.0 / 3;
  if (points.empty()) return;
  Point last = points.front();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool is_end = i + 1 == points.size();
    if (!is_end && std::hypot(points[i].x - last.x, points[i].y - last.y) < shortest) continue;
    stroke(layer, last, points[i], line_width);
    last = points[i];
  }
}

}  // namespace thiessen
