#include "diagram/plane_centres.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/predicates.h"

namespace thiessen {

PlaneCentres::PlaneCentres(const Tessellation<2>& tessellation, const std::vector<bool>& is_needed)
    : tessellation_(tessellation),
      topology_(tessellation.topology()),
      groups_(topology_.size()),
      centre_(topology_.size()),
      known_(topology_.size(), Known::nothing) {
  const auto is_asked = [&](VertexId v) {
    if (topology_.is_infinite(v)) return false;
    if (is_needed.empty()) return true;
    int needed = 0;
    for (const PointId p : topology_.forming(v)) needed += is_needed[index(p)] ? 1 : 0;
    return needed >= 2;
  };
  if (!find_distinct(is_asked)) find_groups(is_asked);
}

// Computes the centre of each simplex by itself. That is all there is to do where no two of
// neighbours come near each other: those of cocircular ones are within their roundings. False
// where two do.
template <typename IsAsked>
bool PlaneCentres::find_distinct(const IsAsked& is_asked) {
  constexpr double roundings = 8;
  topology_.for_each_vertex([&](VertexId v) {
    if (!is_asked(v)) return;
    known_[index(v)] = Known::asked;
    centre_[index(v)] = centre_of(v);
  });
  for (std::uint32_t i = 0; i < known_.size(); ++i) {
    const VertexId v{i};
    if (known_[i] != Known::asked) continue;
    for (const VertexId w : topology_.row(v).neighbours) {
      if (known_[index(w)] == Known::asked && w < v) continue;
      if (topology_.is_infinite(w)) continue;
      if (known_[index(w)] == Known::nothing) {
        known_[index(w)] = Known::alone;
        centre_[index(w)] = centre_of(w);
      }
      if (are_indistinct(v, w, roundings)) return false;
    }
  }
  return true;
}

template <typename IsAsked>
void PlaneCentres::find_groups(const IsAsked& is_asked) {
  std::fill(known_.begin(), known_.end(), Known::nothing);
  topology_.for_each_vertex([&](VertexId v) {
    if (known_[index(v)] == Known::nothing && is_asked(v)) find_cocircular(v, Known::asked);
  });
  topology_.for_each_vertex([&](VertexId v) {
    if (known_[index(v)] == Known::asked) unite_indistinct(v);
  });
  while (!newly_asked_.empty()) {
    const VertexId v = newly_asked_.back();
    newly_asked_.pop_back();
    unite_indistinct(v);
  }
  if (any_indistinct_) compute_united();
}

// Unites a simplex with all that are cocircular with it, and computes their centre. It is that of
// the lexicographically first of them, so that it does not depend on the order in which the places
// came.
void PlaneCentres::find_cocircular(VertexId v, Known known) {
  group_.assign(1, v);
  known_[index(v)] = known;
  for (std::size_t i = 0; i < group_.size(); ++i) {
    for (std::size_t side = 0; side < 3; ++side) {
      const VertexId w = topology_.neighbour(group_[i], side);
      if (known_[index(w)] != Known::nothing || topology_.is_infinite(w)) continue;
      if (!are_cocircular(group_[i], w)) continue;
      known_[index(w)] = known;
      group_.push_back(w);
    }
  }
  const Point centre = centre_of(first_of(group_));
  for (const VertexId w : group_) {
    groups_.unite(group_of(v), group_of(w));
    centre_[index(w)] = centre;
  }
}

// Asks for the centre of a simplex that was known alone, and so for all that are cocircular with
// it.
void PlaneCentres::ask_cocircular(VertexId v) {
  group_.assign(1, v);
  known_[index(v)] = Known::asked;
  for (std::size_t i = 0; i < group_.size(); ++i) {
    for (std::size_t side = 0; side < 3; ++side) {
      const VertexId w = topology_.neighbour(group_[i], side);
      if (known_[index(w)] != Known::alone || !are_cocircular(group_[i], w)) continue;
      known_[index(w)] = Known::asked;
      group_.push_back(w);
    }
  }
  newly_asked_.insert(newly_asked_.end(), group_.begin(), group_.end());
}

// What is united with a simplex that is asked for is asked for itself, because its own neighbours
// may belong to the group, too.
void PlaneCentres::unite_indistinct(VertexId v) {
  for (std::size_t side = 0; side < 3; ++side) {
    const VertexId w = topology_.neighbour(v, side);
    if (topology_.is_infinite(w)) continue;
    if (known_[index(w)] == Known::nothing) find_cocircular(w, Known::alone);
    // The pair is compared once where both are asked for.
    if (known_[index(w)] == Known::asked && w < v) continue;
    if (group_of(v) == group_of(w) || !are_indistinct(v, w)) continue;
    groups_.unite(group_of(v), group_of(w));
    any_indistinct_ = true;
    if (known_[index(w)] == Known::alone) ask_cocircular(w);
  }
}

void PlaneCentres::compute_united() {
  std::vector<VertexId> first(topology_.size(), no_vertex);
  const auto for_each_asked = [&](auto&& visit) {
    topology_.for_each_vertex([&](VertexId v) {
      if (known_[index(v)] == Known::asked) visit(v);
    });
  };
  for_each_asked([&](VertexId v) {
    VertexId& best = first[group_of(v)];
    if (best == no_vertex || corners_of(v) < corners_of(best)) best = v;
  });
  for_each_asked([&](VertexId v) {
    if (first[group_of(v)] == v) centre_[index(v)] = centre_of(v);
  });
  for_each_asked([&](VertexId v) { centre_[index(v)] = centre_[index(first[group_of(v)])]; });
}

VertexId PlaneCentres::first_of(const std::vector<VertexId>& simplices) const {
  VertexId first = simplices.front();
  for (std::size_t i = 1; i < simplices.size(); ++i) {
    if (corners_of(simplices[i]) < corners_of(first)) first = simplices[i];
  }
  return first;
}

Point PlaneCentres::centre_of(VertexId v) const {
  const auto& f = topology_.forming(v);
  return circumcentre(position(f[0]), position(f[1]), position(f[2]));
}

bool PlaneCentres::are_cocircular(VertexId v, VertexId w) const {
  const auto& f = topology_.forming(v);
  const PointId across = topology_.forming(w)[topology_.side_towards(w, v)];
  return in_circle(position(f[0]), position(f[1]), position(f[2]), position(across)) == 0;
}

bool PlaneCentres::are_indistinct(VertexId v, VertexId w, double roundings) const {
  const Point p = centre_[index(v)];
  const Point q = centre_[index(w)];
  const double allowed = roundings * (rounding(v) + rounding(w));
  return std::max(std::abs(q.x - p.x), std::abs(q.y - p.y)) <= allowed;
}

// How far a computed centre may be from the true one: see circumcentre.
double PlaneCentres::rounding(VertexId v) const {
  const Point centre = centre_[index(v)];
  const Point corner = position(topology_.forming(v)[0]);
  return 0x1p-47 * (std::abs(centre.x - corner.x) + std::abs(centre.y - corner.y)) +
         0x1p-52 * std::max(std::abs(centre.x), std::abs(centre.y));
}

std::array<Point, 3> PlaneCentres::corners_of(VertexId v) const {
  const auto& f = topology_.forming(v);
  std::array<Point, 3> corners{position(f[0]), position(f[1]), position(f[2])};
  std::sort(corners.begin(), corners.end());
  return corners;
}

}  // namespace thiessen
