#include "rainfall/errors/sites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "earth/nearest/in_space.h"
#include "earth/nearest/place_tree.h"
#include "geometry/hilbert.h"

namespace thiessen {
namespace {

/// Keeps the nearest of the sites that it is shown, as many as are wanted.
class Nearest {
 public:
  explicit Nearest(std::size_t count) : count_(count) {}

  void show(double square, std::uint32_t site) {
    kept_.emplace_back(square, site);
    std::push_heap(kept_.begin(), kept_.end());
    if (kept_.size() <= count_) return;
    std::pop_heap(kept_.begin(), kept_.end());
    kept_.pop_back();
  }
  /// The distance beyond which no site can be among the nearest any more.
  double reach() const {
    return kept_.size() < count_ ? std::numeric_limits<double>::infinity()
                                 : std::sqrt(kept_.front().first);
  }
  std::vector<std::uint32_t> in_order() {
    std::sort_heap(kept_.begin(), kept_.end());
    std::vector<std::uint32_t> sites;
    sites.reserve(kept_.size());
    for (const auto& [square, site] : kept_) sites.push_back(site);
    return sites;
  }

 private:
  std::size_t count_;
  std::vector<std::pair<double, std::uint32_t>> kept_;
};

}  // namespace

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
  for (std::uint32_t site = 0; site < size(); ++site) {
    // The search is shorter if some near sites are known before it: sites with near numbers are a
    // good guess.
    const std::size_t begin = std::max<std::size_t>(site, count) - count;
    const std::size_t end = std::min(size(), std::size_t{site} + count + 1);
    Nearest guess(count);
    for (std::size_t i = begin; i < end; ++i) {
      if (i != site) guess.show(square_distance(at_[site], at_[i]), static_cast<std::uint32_t>(i));
    }
    const double reach = guess.reach();
    Nearest nearest(count);
    tree.search(
        [&](const Ball& ball) {
          const double nearer = std::min(reach, nearest.reach());
          // The margin keeps a neighbour from being lost to rounding of the ball's centre and
          // radius.
          return length(ball.centre - at_[site]) > (nearer + ball.radius) * (1 + 1e-12);
        },
        [&](PlaceIndex p) {
          if (index(p) != site)
            nearest.show(square_distance(at_[site], at_[index(p)]),
                         static_cast<std::uint32_t>(index(p)));
        });
    all[site] = nearest.in_order();
  }
  return all;
}

}  // namespace thiessen
