#include "earth/nearest/place_tree.h"

#include <algorithm>
#include <array>

namespace thiessen {
namespace {

constexpr std::uint32_t few = 8;

using Axis = double Direction::*;
constexpr std::array<Axis, 3> axes{&Direction::x, &Direction::y, &Direction::z};

double square_between(Direction a, Direction b) {
  return dot(a - b, a - b);
}

}  // namespace

PlaceTree::PlaceTree(std::vector<Direction> places) : places_(std::move(places)) {
  const auto count = static_cast<std::uint32_t>(places_.size());
  for (std::uint32_t i = 0; i < count; ++i) order_.push_back(PlaceIndex{i});
  add_part(0, count);
}

std::uint32_t PlaceTree::add_part(std::uint32_t begin, std::uint32_t end) {
  Direction low = places_[index(order_[begin])];
  Direction high = low;
  for (std::uint32_t k = begin; k < end; ++k) {
    for (const Axis axis : axes) {
      const double at = places_[index(order_[k])].*axis;
      low.*axis = std::min(low.*axis, at);
      high.*axis = std::max(high.*axis, at);
    }
  }
  const Direction size = high - low;
  const auto i = static_cast<std::uint32_t>(parts_.size());
  const Direction centre = low + 0.5 * size;
  double radius = 0;
  for (std::uint32_t k = begin; k < end; ++k) {
    radius = std::max(radius, square_between(places_[index(order_[k])], centre));
  }
  parts_.push_back({{centre, std::sqrt(radius)}, begin, end, 0});
  if (end - begin <= few) return i;
  const Axis longest = *std::max_element(axes.begin(), axes.end(),
                                         [&](Axis a, Axis b) { return size.*a < size.*b; });
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](PlaceIndex a, PlaceIndex b) {
                     return places_[index(a)].*longest < places_[index(b)].*longest;
                   });
  add_part(begin, middle);
  parts_[i].second = add_part(middle, end);
  return i;
}

PlaceIndex PlaceTree::nearest(Direction to) const {
  PlaceIndex best = order_.front();
  double square = square_between(to, places_[index(best)]);
  find_nearest(0, to, best, square);
  return best;
}

void PlaceTree::find_nearest(std::uint32_t i, Direction to, PlaceIndex& best,
                             double& square) const {
  const Part& part = parts_[i];
  const double gap = std::sqrt(square_between(to, part.ball.centre)) - part.ball.radius;
  if (gap > 0 && gap * gap >= square) return;
  if (part.second == 0) {
    for (std::uint32_t k = part.begin; k < part.end; ++k) {
      const double at = square_between(to, places_[index(order_[k])]);
      if (at >= square) continue;
      best = order_[k];
      square = at;
    }
    return;
  }
  const double first = square_between(to, parts_[i + 1].ball.centre);
  const double second = square_between(to, parts_[part.second].ball.centre);
  find_nearest(first <= second ? i + 1 : part.second, to, best, square);
  find_nearest(first <= second ? part.second : i + 1, to, best, square);
}

}  // namespace thiessen
