#include "rainfall/errors/sites.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "earth/nearest/in_space.h"
#include "earth/nearest/near_places.h"
#include "geometry/hilbert.h"

namespace thiessen {
Sites::Sites(std::span<const Point> places, Metric metric)
    : site_of_(places.size()), place_of_(places.size()) {
  Box box;
  for (const Point p : places) box.take_in(p);
  std::vector<std::uint32_t> along(places.size());
  for (std::size_t p = 0; p < places.size(); ++p) along[p] = hilbert_distance(box, places[p]);
  std::iota(place_of_.begin(), place_of_.end(), 0u);
  std::sort(place_of_.begin(), place_of_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(along[a], places[a]) < std::tie(along[b], places[b]);
  });
  at_.reserve(places.size());
  for (std::uint32_t site = 0; site < place_of_.size(); ++site) {
    site_of_[place_of_[site]] = site;
    at_.push_back(in_space(places[place_of_[site]], metric));
  }
}

std::vector<std::vector<std::uint32_t>> Sites::nearest_others(std::size_t count) const {
  std::vector<std::vector<std::uint32_t>> all(size());
  if (size() < 2 || count == 0) return all;
  const PlaceTree tree(at_);
  std::vector<NearPlace> near;
  for (std::uint32_t site = 0; site < size(); ++site) {
    find_near_places(
        tree, at_[site], count, square_within_reach(site, count),
        [&](PlaceIndex p) { return index(p) != site; },
        [](PlaceIndex a, PlaceIndex b) { return a < b; }, near);
    all[site].reserve(near.size());
    for (const NearPlace& other : near)
      all[site].push_back(static_cast<std::uint32_t>(index(other.place)));
  }
  return all;
}

// Sites with near numbers mostly lie near, so the farthest of as many of them bounds the search.
double Sites::square_within_reach(std::uint32_t site, std::size_t count) const {
  const std::size_t begin = std::max<std::size_t>(site, count) - count;
  const std::size_t end = std::min(size(), std::size_t{site} + count + 1);
  std::vector<double> squares;
  for (std::size_t i = begin; i < end; ++i) {
    if (i != site) squares.push_back(square_distance(at_[site], at_[i]));
  }
  if (squares.size() < count) return std::numeric_limits<double>::infinity();
  const auto last = squares.begin() + static_cast<std::ptrdiff_t>(count - 1);
  std::nth_element(squares.begin(), last, squares.end());
  return *last;
}

}  // namespace thiessen
