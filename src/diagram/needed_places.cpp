#include "diagram/needed_places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "geometry/box.h"

namespace thiessen {
namespace {

constexpr std::size_t few_places = 500;
constexpr double most_of_the_surroundings = 0.7;
/// Squares that are smaller beside the coordinates would be blurred by their rounding.
constexpr double smallest_square = 0x1p-30;

template <typename Visit>
void for_each_ring(const MultiPolygon& shape, Visit&& visit) {
  for (const Polygon& part : shape) {
    visit(part.outer);
    for (const Ring& hole : part.holes) visit(hole);
  }
}

/// Calls visit(from, to) for every edge.
template <typename Visit>
void for_each_edge(const MultiPolygon& shape, Visit&& visit) {
  for_each_ring(shape, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      visit(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  });
}

double area_of(const MultiPolygon& shape) {
  double area = 0;
  if (shape.empty() || shape.front().outer.empty()) return 0;
  const Point origin = shape.front().outer.front();
  for_each_edge(shape, [&](Point a, Point b) {
    area += (a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y);
  });
  return std::abs(area) / 2;
}

/// Squares side by side over a box, each with a number that is at hand.
class Squares {
 public:
  Squares(const Box& box, std::size_t count) : low_(box.low) {
    const auto wanted = static_cast<double>(count);
    side_ = std::max(std::sqrt(box.width() * box.height() / wanted),
                     std::max(box.width(), box.height()) / wanted);
    columns_ = static_cast<std::ptrdiff_t>(box.width() / side_) + 1;
    rows_ = static_cast<std::ptrdiff_t>(box.height() / side_) + 1;
  }

  double side() const { return side_; }
  std::ptrdiff_t columns() const { return columns_; }
  std::ptrdiff_t rows() const { return rows_; }
  std::size_t count() const { return static_cast<std::size_t>(columns_ * rows_); }
  /// The column and the row at a coordinate; the nearest where it lies beyond them.
  std::ptrdiff_t column(double x) const { return within(x - low_.x, columns_); }
  std::ptrdiff_t row(double y) const { return within(y - low_.y, rows_); }
  double middle_of_row(std::ptrdiff_t row) const {
    return low_.y + (static_cast<double>(row) + 0.5) * side_;
  }
  std::size_t at(std::ptrdiff_t column, std::ptrdiff_t row) const {
    return static_cast<std::size_t>(row * columns_ + column);
  }
  std::size_t at(Point p) const { return at(column(p.x), row(p.y)); }

  /// Makes of each square's number the least that any square has together with the steps from there
  /// to here, straight or across corners: there and back again, as in a chamfer.
  void spread(std::vector<std::int32_t>& numbers) const {
    const auto take = [&](std::int32_t& number, std::ptrdiff_t column, std::ptrdiff_t row) {
      if (column < 0 || column >= columns_ || row < 0 || row >= rows_) return;
      number = std::min(number, numbers[at(column, row)] + 1);
    };
    const auto settle = [&](std::ptrdiff_t column, std::ptrdiff_t row, std::ptrdiff_t back) {
      std::int32_t& number = numbers[at(column, row)];
      take(number, column - back, row);
      for (const std::ptrdiff_t beside : {-1, 0, 1}) take(number, column + beside, row - back);
    };
    for (std::ptrdiff_t row = 0; row < rows_; ++row) {
      for (std::ptrdiff_t column = 0; column < columns_; ++column) settle(column, row, 1);
    }
    for (std::ptrdiff_t row = rows_; row-- > 0;) {
      for (std::ptrdiff_t column = columns_; column-- > 0;) settle(column, row, -1);
    }
  }

 private:
  std::ptrdiff_t within(double way, std::ptrdiff_t count) const {
    const double steps = std::floor(way / side_);
    return static_cast<std::ptrdiff_t>(std::clamp(steps, 0.0, static_cast<double>(count - 1)));
  }

  Point low_;
  double side_ = 0;
  std::ptrdiff_t columns_ = 0;
  std::ptrdiff_t rows_ = 0;
};

/// Marks the squares that ground meets, and those that it nearly meets.
class GroundMarks {
 public:
  explicit GroundMarks(const Squares& squares)
      : squares_(squares), is_ground_(squares.count(), false) {}

  void add(const MultiPolygon& shape) {
    ways_in_.clear();
    for_each_edge(shape, [&](Point a, Point b) {
      mark_along(a, b);
      add_ways_in(a, b);
    });
    mark_inside();
  }
  const std::vector<bool>& is_ground() const { return is_ground_; }

 private:
  struct WayIn {  // where an edge passes the middle line of a row
    std::ptrdiff_t row;
    double x;
  };

  void mark(const Box& box) {
    for (std::ptrdiff_t row = squares_.row(box.low.y); row <= squares_.row(box.high.y); ++row) {
      for (std::ptrdiff_t c = squares_.column(box.low.x); c <= squares_.column(box.high.x); ++c)
        is_ground_[squares_.at(c, row)] = true;
    }
  }
  // An edge is halved until the pieces' boxes are small, or flat.
  void mark_along(Point a, Point b) {
    const Box box = box_of(a, b);
    if (std::min(box.width(), box.height()) <= squares_.side()) {
      mark(box.grown(squares_.side() / 16));
      return;
    }
    const Point middle = box.centre();
    mark_along(a, middle);
    mark_along(middle, b);
  }
  void add_ways_in(Point a, Point b) {
    if (b.y < a.y) std::swap(a, b);
    for (std::ptrdiff_t row = squares_.row(a.y); row <= squares_.row(b.y); ++row) {
      const double y = squares_.middle_of_row(row);
      if (a.y < y && y <= b.y)
        ways_in_.push_back({row, a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y))});
    }
  }
  // A square that no edge meets lies inside as a whole where its middle does.
  void mark_inside() {
    std::sort(ways_in_.begin(), ways_in_.end(), [](const WayIn& a, const WayIn& b) {
      return a.row != b.row ? a.row < b.row : a.x < b.x;
    });
    for (std::size_t i = 0; i + 1 < ways_in_.size(); i += 2) {
      const std::ptrdiff_t end = squares_.column(ways_in_[i + 1].x);
      for (std::ptrdiff_t c = squares_.column(ways_in_[i].x); c <= end; ++c)
        is_ground_[squares_.at(c, ways_in_[i].row)] = true;
    }
  }

  const Squares& squares_;
  std::vector<bool> is_ground_;
  std::vector<WayIn> ways_in_;
};

}  // namespace

std::vector<bool> needed_places(std::span<const Point> places,
                                std::span<const MultiPolygon* const> ground) {
  if (places.size() < few_places || ground.empty()) return {};
  Box around;
  for (const Point p : places) around.take_in(p);
  double area = 0;
  for (const MultiPolygon* const shape : ground) area += area_of(*shape);
  if (area > most_of_the_surroundings * around.width() * around.height()) return {};
  for (const MultiPolygon* const shape : ground)
    for_each_edge(*shape, [&](Point a, Point) { around.take_in(a); });

  const Squares squares(around, places.size() / 4);
  const double largest = std::max({std::abs(around.low.x), std::abs(around.low.y),
                                   std::abs(around.high.x), std::abs(around.high.y)});
  if (squares.side() < smallest_square * largest) return {};
  constexpr std::int32_t far = 1 << 28;
  std::vector<std::int32_t> away(squares.count(), far);  // from the nearest square with a place
  for (const Point p : places) away[squares.at(p)] = 0;
  squares.spread(away);

  GroundMarks marks(squares);
  for (const MultiPolygon* const shape : ground) marks.add(*shape);
  // By square: how many less than `far` squares the reach of some ground goes on from here. A
  // square's own reach is the diagonal of the squares up to the nearest place's, and a bit more.
  std::vector<std::int32_t> reach(squares.count(), far);
  for (std::size_t i = 0; i < reach.size(); ++i)
    if (marks.is_ground()[i]) reach[i] = -((away[i] + 1) * 3 + 1) / 2;
  squares.spread(reach);

  std::vector<bool> is_needed(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) is_needed[i] = reach[squares.at(places[i])] <= 0;
  return is_needed;
}

}  // namespace thiessen
