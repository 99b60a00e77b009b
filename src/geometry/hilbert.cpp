#include "geometry/hilbert.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace thiessen {
namespace {

constexpr std::uint32_t grid_side = 1u << 16;

std::uint32_t grid_step(double low, double length, double value) {
  if (!(length > 0)) return 0;
  const double share = (value - low) / length * grid_side;
  return static_cast<std::uint32_t>(std::clamp(share, 0.0, double{grid_side - 1}));
}

}  // namespace

std::uint32_t hilbert_distance(const Box& box, Point p) {
  std::uint32_t x = grid_step(box.low.x, box.width(), p.x);
  std::uint32_t y = grid_step(box.low.y, box.height(), p.y);
  std::uint32_t distance = 0;
  for (std::uint32_t side = grid_side / 2; side > 0; side /= 2) {
    const bool east = (x & side) != 0;
    const bool north = (y & side) != 0;
    distance += side * side * ((east ? 3u : 0u) ^ (north ? 1u : 0u));
    if (!north) {
      if (east) {
        x = grid_side - 1 - x;
        y = grid_side - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return distance;
}

namespace {

/// Puts points in their order along Hilbert's curve through their box, those of one cell of its
/// grid along the curve through theirs, and so on.
class CurveOrder {
 public:
  explicit CurveOrder(std::span<const Point> points) : points_(points) {}

  void sort(std::span<std::uint32_t> order) {
    Box box;
    for (const std::uint32_t i : order) box.take_in(points_[i]);
    if (!(box.width() > 0) && !(box.height() > 0)) return;
    keys_.clear();
    for (const std::uint32_t i : order) {
      keys_.push_back(std::uint64_t{hilbert_distance(box, points_[i])} << 32 | i);
    }
    std::sort(keys_.begin(), keys_.end());
    std::vector<std::span<std::uint32_t>> crowded;
    for (std::size_t first = 0; first < keys_.size();) {
      std::size_t end = first;
      for (; end < keys_.size() && keys_[end] >> 32 == keys_[first] >> 32; ++end) {
        order[end] = static_cast<std::uint32_t>(keys_[end]);
      }
      if (end - first > crowd) crowded.push_back(order.subspan(first, end - first));
      first = end;
    }
    for (const std::span<std::uint32_t> cell : crowded) sort(cell);
  }

 private:
  static constexpr std::size_t crowd = 8;

  std::span<const Point> points_;
  std::vector<std::uint64_t> keys_;  // the distance, and below it the position
};

}  // namespace

std::vector<std::uint32_t> insertion_order(std::span<const Point> points) {
  constexpr std::size_t first_round = 64;
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::minstd_rand random;
  std::shuffle(order.begin(), order.end(), random);

  CurveOrder curve(points);
  for (std::size_t left = order.size(); left > 0;) {
    const std::size_t begin = left <= first_round ? 0 : left / 2;
    curve.sort(std::span(order).subspan(begin, left - begin));
    left = begin;
  }
  return order;
}

}  // namespace thiessen
