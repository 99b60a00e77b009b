#include "geometry/signposts.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace thiessen {
namespace {

template <typename Signpost>
std::size_t longest_axis(std::span<const Signpost> part) {
  auto low = coordinates(part.front().position);
  auto high = low;
  for (const Signpost& signpost : part) {
    const auto c = coordinates(signpost.position);
    for (std::size_t axis = 0; axis < c.size(); ++axis) {
      low[axis] = std::min(low[axis], c[axis]);
      high[axis] = std::max(high[axis], c[axis]);
    }
  }
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < low.size(); ++axis) {
    if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
  }
  return longest;
}

/// Parts the signposts at `middle`, so that those with lesser coordinates come first. Returns the
/// plane between the two halves.
template <typename Signpost>
double halve(std::span<Signpost> part, std::size_t middle, std::size_t axis) {
  const auto along = [axis](const Signpost& s) { return coordinates(s.position)[axis]; };
  const auto less = [&](const Signpost& a, const Signpost& b) { return along(a) < along(b); };
  const auto upper = part.begin() + static_cast<std::ptrdiff_t>(middle);
  std::nth_element(part.begin(), upper, part.end(), less);
  return along(*std::max_element(part.begin(), upper, less)) / 2 + along(*upper) / 2;
}

}  // namespace

template <int Dimension>
void Signposts<Dimension>::set(std::vector<Signpost> sample) {
  const int levels = levels_of(sample.size());
  Ordinals beyond_all;
  beyond_all.fill(std::numeric_limits<std::int64_t>::max());
  planes_ = std::vector<Ordinals>(std::size_t{1} << levels, beyond_all);
  sample_ = std::move(sample);
  levels_ = levels;

  for (int level = 0; level < levels_; ++level) {
    for (std::size_t i = 0; i < std::size_t{1} << level; ++i) {
      const std::size_t begin = begin_of(i, level);
      const std::size_t middle = begin_of(2 * i + 1, level + 1);
      const std::span<Signpost> part =
          std::span(sample_).subspan(begin, begin_of(i + 1, level) - begin);
      const std::size_t axis = longest_axis(std::span<const Signpost>(part));
      planes_[(std::size_t{1} << level) + i][axis] = ordinal(halve(part, middle - begin, axis));
    }
  }
}

template class Signposts<2>;
template class Signposts<3>;

}  // namespace thiessen
