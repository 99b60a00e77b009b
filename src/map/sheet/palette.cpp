#include "map/sheet/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace thiessen {
namespace {

constexpr std::array<Colour, 9> viridis{{{68, 1, 84},
                                         {71, 44, 122},
                                         {59, 81, 139},
                                         {44, 113, 142},
                                         {33, 144, 141},
                                         {39, 173, 129},
                                         {92, 200, 99},
                                         {170, 220, 50},
                                         {253, 231, 37}}};
// The palest of these three are so much darker than dry ground that grey print shows it.
constexpr std::array<Colour, 5> blues{
    {{178, 208, 232}, {116, 168, 211}, {62, 129, 186}, {25, 86, 150}, {10, 44, 104}}};
constexpr std::array<Colour, 5> browns{
    {{232, 200, 152}, {204, 154, 93}, {167, 111, 52}, {121, 70, 24}, {76, 38, 8}}};
constexpr std::array<Colour, 5> greys{
    {{204, 204, 204}, {161, 161, 161}, {118, 118, 118}, {75, 75, 75}, {32, 32, 32}}};

std::span<const Colour> anchors_of(Palette palette) {
  switch (palette) {
    case Palette::viridis:
      return viridis;
    case Palette::blues:
      return blues;
    case Palette::browns:
      return browns;
    case Palette::greys:
      return greys;
  }
  return {};
}

std::uint8_t between(std::uint8_t a, std::uint8_t b, double t) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * t));
}

/// The neighbours of each item, listed one item after the other.
struct Adjacency {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> list;

  std::span<const std::uint32_t> of(std::size_t item) const {
    return std::span(list).subspan(begin[item], begin[item + 1] - begin[item]);
  }
};

Adjacency adjacency(std::size_t count, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs) {
  const std::size_t given = pairs.size();
  for (std::size_t i = 0; i < given; ++i) pairs.push_back({pairs[i].second, pairs[i].first});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Adjacency result{std::vector<std::size_t>(count + 1), {}};
  for (const auto& [from, to] : pairs) {
    if (from == to) continue;
    ++result.begin[from + 1];
    result.list.push_back(to);
  }
  for (std::size_t i = 0; i < count; ++i) result.begin[i + 1] += result.begin[i];
  return result;
}

/// The items in an order in which each has few neighbours among those after it: the one with the
/// fewest neighbours left is always taken next.
std::vector<std::uint32_t> smallest_first(const Adjacency& neighbours, std::size_t count) {
  std::vector<std::size_t> degree(count);
  std::vector<std::vector<std::uint32_t>> of_degree(1);
  const auto queue = [&](std::uint32_t item) {
    if (of_degree.size() <= degree[item]) of_degree.resize(degree[item] + 1);
    of_degree[degree[item]].push_back(item);
  };
  for (std::size_t i = count; i-- > 0;) {
    degree[i] = neighbours.of(i).size();
    queue(static_cast<std::uint32_t>(i));
  }
  std::vector<bool> taken(count, false);
  std::vector<std::uint32_t> order;
  for (std::size_t least = 0; least < of_degree.size();) {
    if (of_degree[least].empty()) {
      ++least;
      continue;
    }
    const std::uint32_t item = of_degree[least].back();
    of_degree[least].pop_back();
    if (taken[item] || degree[item] != least) continue;
    taken[item] = true;
    order.push_back(item);
    for (const std::uint32_t other : neighbours.of(item)) {
      if (taken[other]) continue;
      --degree[other];
      queue(other);
    }
    if (least > 0) --least;
  }
  return order;
}

}  // namespace

void TouchingPairs::add(std::uint32_t a, std::uint32_t b) {
  const Pair pair = std::minmax(a, b);
  if (a == b || (!pairs_.empty() && pairs_.back() == pair)) return;
  pairs_.push_back(pair);
  if (pairs_.size() < most_) return;
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  most_ = std::max(most_, 2 * pairs_.size());
}

Colour sequential_colour(Palette palette, std::size_t index, std::size_t count) {
  const std::span<const Colour> anchors = anchors_of(palette);
  const double last = static_cast<double>(anchors.size() - 1);
  const double share =
      count < 2 ? 0.5 : static_cast<double>(index) / static_cast<double>(count - 1);
  const double position = std::clamp(share, 0.0, 1.0) * last;
  const auto below = static_cast<std::size_t>(std::min(std::floor(position), last - 1));
  const double t = position - static_cast<double>(below);
  const Colour& a = anchors[below];
  const Colour& b = anchors[below + 1];
  return {between(a.red, b.red, t), between(a.green, b.green, t), between(a.blue, b.blue, t)};
}

std::span<const Colour> categorical_colours() {
  static constexpr std::array<Colour, 8> colours{{{169, 207, 226},
                                                  {248, 208, 160},
                                                  {186, 221, 174},
                                                  {216, 198, 228},
                                                  {245, 234, 168},
                                                  {240, 188, 190},
                                                  {166, 218, 208},
                                                  {216, 208, 188}}};
  return colours;
}

std::vector<std::uint8_t> colour_neighbours(
    std::size_t count, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs,
    std::size_t colours) {
  constexpr std::uint8_t none = 255;
  const Adjacency neighbours = adjacency(count, std::move(pairs));
  std::vector<std::uint32_t> order = smallest_first(neighbours, count);
  std::reverse(order.begin(), order.end());
  std::vector<std::uint8_t> chosen(count, none);
  std::vector<std::size_t> used(colours, 0);
  std::vector<std::size_t> around(colours, 0);
  for (const std::uint32_t item : order) {
    std::fill(around.begin(), around.end(), 0);
    for (const std::uint32_t other : neighbours.of(item)) {
      if (chosen[other] != none) ++around[chosen[other]];
    }
    std::size_t best = 0;
    for (std::size_t c = 1; c < colours; ++c) {
      if (std::pair(around[c], used[c]) < std::pair(around[best], used[best])) best = c;
    }
    chosen[item] = static_cast<std::uint8_t>(best);
    ++used[best];
  }
  return chosen;
}

}  // namespace thiessen
