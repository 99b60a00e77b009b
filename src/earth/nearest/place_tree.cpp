#include "earth/nearest/place_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace thiessen {
namespace {

constexpr std::uint32_t few = 8;

using Axis = double Direction::*;
constexpr std::array<Axis, 3> axes{&Direction::x, &Direction::y, &Direction::z};

double square_between(Direction a, Direction b) {
  return dot(a - b, a - b);
}

}  // namespace

// The entries have their places' coordinates beside them, for they are looked at again and again,
// and would else wait for the memory.
PlaceTree::PlaceTree(std::vector<Direction> places) : places_(std::move(places)) {
  const auto count = static_cast<std::uint32_t>(places_.size());
  std::vector<Entry> entries;
  entries.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) entries.push_back({places_[i], PlaceIndex{i}});
  add_part(entries, 0, count);
  order_.reserve(count);
  for (const Entry& entry : entries) order_.push_back(entry.place);
}

std::uint32_t PlaceTree::add_part(std::vector<Entry>& entries, std::uint32_t begin,
                                  std::uint32_t end) {
  Direction low = entries[begin].at;
  Direction high = low;
  for (std::uint32_t k = begin; k < end; ++k) {
    for (const Axis axis : axes) {
      const double at = entries[k].at.*axis;
      low.*axis = std::min(low.*axis, at);
      high.*axis = std::max(high.*axis, at);
    }
  }
  const Direction size = high - low;
  const auto i = static_cast<std::uint32_t>(parts_.size());
  const Direction centre = low + 0.5 * size;
  double radius = 0;
  for (std::uint32_t k = begin; k < end; ++k)
    radius = std::max(radius, square_between(entries[k].at, centre));
  parts_.push_back({{centre, std::sqrt(radius)}, begin, end, 0});
  if (end - begin <= few) return i;
  const Axis longest = *std::max_element(axes.begin(), axes.end(),
                                         [&](Axis a, Axis b) { return size.*a < size.*b; });
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(entries.begin() + begin, entries.begin() + middle, entries.begin() + end,
                   [&](const Entry& a, const Entry& b) { return a.at.*longest < b.at.*longest; });
  add_part(entries, begin, middle);
  parts_[i].second = add_part(entries, middle, end);
  return i;
}

// The guess is taken for a little farther than it is, so that it wins over no place as near.
PlaceIndex PlaceTree::nearest(Direction to, PlaceIndex guess) const {
  constexpr double rounding = 1e-15;
  const double square = square_between(to, places_[index(guess)]) * (1 + rounding);
  Nearest search{to, guess, square, std::sqrt(square)};
  find_nearest(0, search);
  return search.best;
}

void PlaceTree::find_nearest(std::uint32_t i, Nearest& search) const {
  const Part& part = parts_[i];
  if (search.excludes(part.ball)) return;
  if (part.second == 0) {
    for (std::uint32_t k = part.begin; k < part.end; ++k) {
      const double at = square_between(search.to, places_[index(order_[k])]);
      if (at >= search.square) continue;
      search.best = order_[k];
      search.square = at;
      search.distance = std::sqrt(at);
    }
    return;
  }
  const double first = square_between(search.to, parts_[i + 1].ball.centre);
  const double second = square_between(search.to, parts_[part.second].ball.centre);
  find_nearest(first <= second ? i + 1 : part.second, search);
  find_nearest(first <= second ? part.second : i + 1, search);
}

}  // namespace thiessen
