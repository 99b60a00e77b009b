#include "rainfall/normals/pixel_mapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace thiessen {
namespace {

constexpr std::size_t most_intervals = 256;

/// The four nodes that a position lies among, and their weights in the cubic through them.
struct Cubic {
  std::size_t first;
  std::array<double, 4> weight;
};

Cubic cubic_at(double position, std::size_t intervals) {
  const double last = static_cast<double>(intervals - 3);
  // As std::floor gives it, without a call.
  const auto before =
      static_cast<double>(static_cast<std::int64_t>(std::clamp(position, 1.0, last + 1)));
  const double first = before - 1;
  const double t = position - first;
  return {static_cast<std::size_t>(first),
          {-(t - 1) * (t - 2) * (t - 3) / 6, t * (t - 2) * (t - 3) / 2, -t * (t - 1) * (t - 3) / 2,
           t * (t - 1) * (t - 2) / 6}};
}

}  // namespace

SmoothMapping::SmoothMapping(const Exact& exact, const Box& frame, double tolerance)
    : frame_(frame) {
  for (;; intervals_ *= 2) {
    take_nodes(exact);
    error_ = error_between(exact);
    if (!(error_ > tolerance) || intervals_ == most_intervals) return;
  }
}

void SmoothMapping::take_nodes(const Exact& exact) {
  const double step = 1 / static_cast<double>(intervals_);
  std::vector<Point> points;
  points.reserve((intervals_ + 1) * (intervals_ + 1));
  for (std::size_t j = 0; j <= intervals_; ++j) {
    for (std::size_t i = 0; i <= intervals_; ++i) {
      points.push_back({frame_.low.x + static_cast<double>(i) * step * frame_.width(),
                        frame_.low.y + static_cast<double>(j) * step * frame_.height()});
    }
  }
  nodes_ = exact(std::move(points));
}

double SmoothMapping::error_between(const Exact& exact) const {
  const double step = 1 / static_cast<double>(intervals_);
  std::vector<Point> points;
  for (std::size_t j = 0; j < intervals_; ++j) {
    for (std::size_t i = 0; i < intervals_; ++i) {
      points.push_back({frame_.low.x + (static_cast<double>(i) + 0.5) * step * frame_.width(),
                        frame_.low.y + (static_cast<double>(j) + 0.5) * step * frame_.height()});
    }
  }
  const std::vector<Point> mapped = exact(points);
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point here = to_pixels(points[i]);
    const double error = std::hypot(here.x - mapped[i].x, here.y - mapped[i].y);
    if (std::isnan(error)) return error;
    largest = std::max(largest, error);
  }
  return largest;
}

Point SmoothMapping::to_pixels(Point ground) const {
  const double intervals = static_cast<double>(intervals_);
  const double width = frame_.width() > 0 ? frame_.width() : 1;
  const double height = frame_.height() > 0 ? frame_.height() : 1;
  const Cubic along = cubic_at((ground.x - frame_.low.x) / width * intervals, intervals_);
  const Cubic up = cubic_at((ground.y - frame_.low.y) / height * intervals, intervals_);
  Point sum;
  for (std::size_t j = 0; j < 4; ++j) {
    const Point* const node = &nodes_[(up.first + j) * (intervals_ + 1) + along.first];
    Point of_row;
    for (std::size_t i = 0; i < 4; ++i) {
      of_row.x += along.weight[i] * node[i].x;
      of_row.y += along.weight[i] * node[i].y;
    }
    sum.x += up.weight[j] * of_row.x;
    sum.y += up.weight[j] * of_row.y;
  }
  return sum;
}

}  // namespace thiessen
