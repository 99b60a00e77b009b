#include "map/ink/line_places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace thiessen {
namespace {

/// Finds points by their distance along a line.
class Walk {
 public:
  explicit Walk(std::span<const Point> line) : line_(line) {
    lengths_.reserve(line.size());
    for (std::size_t i = 0; i < line.size(); ++i)
      lengths_.push_back(i == 0 ? 0 : lengths_[i - 1] + distance(line[i - 1], line[i]));
  }

  double length() const { return lengths_.empty() ? 0 : lengths_.back(); }
  Point at(double along) const {
    const auto end = std::lower_bound(lengths_.begin(), lengths_.end(), along);
    const auto i = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(end - lengths_.begin(), 1, std::ssize(lengths_) - 1));
    const double step = lengths_[i] - lengths_[i - 1];
    const double share = step > 0 ? std::clamp((along - lengths_[i - 1]) / step, 0.0, 1.0) : 0;
    return {std::lerp(line_[i - 1].x, line_[i].x, share),
            std::lerp(line_[i - 1].y, line_[i].y, share)};
  }

 private:
  static double distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

  std::span<const Point> line_;
  std::vector<double> lengths_;
};

}  // namespace

std::vector<Point> text_places(std::span<const Point> line, double width) {
  constexpr double least_length = 2;  // of the line, in widths of the text
  struct Place {
    Point at;
    long goodness;
  };
  const Walk walk(line);
  if (line.size() < 2 || !(width > 0) || walk.length() < least_length * width) return {};
  std::vector<Place> places;
  for (double along = width / 2; along <= walk.length() - width / 2; along += width / 4) {
    const double across = std::abs(walk.at(along + width / 2).x - walk.at(along - width / 2).x);
    places.push_back({walk.at(along), std::lround(across / width * 8)});
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.goodness > b.goodness; });
  std::vector<Point> points;
  points.reserve(places.size());
  for (const Place& place : places) points.push_back(place.at);
  return points;
}

}  // namespace thiessen
