#include "rainfall/methods/plane_stolen_areas.h"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.h"
#include "geometry/voronoi_measures.h"

namespace thiessen {
namespace {

constexpr double unit = 0x1p-53;
constexpr double largest_error = 2e-13;  // as a share of all that is taken

/// A number and a bound on its error.
struct Bounded {
  double value;
  double error;

  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    const double product = a.value * b.value;
    return {product, a.error * std::abs(b.value) + std::abs(a.value) * b.error + a.error * b.error +
                         4 * unit * std::abs(product)};
  }
};

/// The bound of an in-circle determinant covers the rounding of its vectors too.
Bounded bounded(const Estimate& lift) {
  return {lift.value, 16 * unit * lift.magnitude};
}

/// A lift divided by two areas, each of which is right to 25 units.
Bounded over(const Bounded& lift, double left, double right) {
  const double value = lift.value / (left * right);
  return {value, std::abs(lift.error / (left * right)) + 64 * unit * std::abs(value)};
}

PlaneVector<Estimate> seen(Point v) {
  return {{v.x, std::abs(v.x)}, {v.y, std::abs(v.y)}};
}

template <typename Corner>
Bounded lift_of(const Corner& a, const Corner& b, const Corner& c) {
  return bounded(determinant::in_circle(seen(a.from_x), seen(b.from_x), seen(c.from_x)));
}

/// The square of q's distance from x less that of p's.
template <typename Corner>
Bounded difference_of_squares(const Corner& p, const Corner& q) {
  const double step_x = q.position.x - p.position.x;
  const double step_y = q.position.y - p.position.y;
  const double reach_x = std::abs(p.from_x.x) + std::abs(q.from_x.x);
  const double reach_y = std::abs(p.from_x.y) + std::abs(q.from_x.y);
  return {step_x * (p.from_x.x + q.from_x.x) + step_y * (p.from_x.y + q.from_x.y),
          6 * unit * (std::abs(step_x) * reach_x + std::abs(step_y) * reach_y)};
}

}  // namespace

// Returns a bound on the errors of all sums. Terms whose bound is above `limit` are computed
// exactly.
double PlaneStolenAreas::add_all(const Structure<2>& structure, const ConflictZone<2>& zone,
                                 Point x, double limit) {
  const Topology<2>& topology = structure.topology();
  const std::size_t count = corners_.size();
  double error = 0;
  sums_.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Corner& before = corners_[i > 0 ? i - 1 : count - 1];
    const Corner& p = corners_[i];
    const std::size_t next = i + 1 < count ? i + 1 : 0;
    const Corner& q = corners_[next];
    const auto& facet = zone.rim()[i];
    const Corner& third = corner(topology.forming(facet.inside)[facet.side]);
    const Bounded lift = lift_of(before, p, q);
    Bounded taken = over(lift, before.doubled_area, p.doubled_area) * Bounded{p.square, 0};
    if (taken.error > limit)
      taken = {edge_ratio(x, p.position, q.position, before.position) * p.square, 0};
    sums_[i] += taken.value;
    const Bounded kept =
        over(lift_of(p, q, third), p.doubled_area, doubled_area_[index(facet.inside)]) *
        difference_of_squares(p, q);
    const double term = kept.error <= limit
                            ? kept.value
                            : edge_ratio(p.position, q.position, third.position, x) *
                                  square_difference(x, p.position, q.position);
    sums_[i] += term;
    sums_[next] -= term;
    error += taken.error + kept.error;
  }
  return error + add_inner(structure, zone, x, limit);
}

double PlaneStolenAreas::add_inner(const Structure<2>& structure, const ConflictZone<2>& zone,
                                   Point x, double limit) {
  const Topology<2>& topology = structure.topology();
  double error = 0;
  for (const VertexId v : zone.vertices()) {
    for (std::size_t side = 0; side < 3; ++side) {
      const VertexId w = topology.neighbour(v, side);
      if (w < v || mark_[index(w)] != zone_number_) continue;
      const auto& forming = topology.forming(v);
      const std::uint32_t i = local_[index(forming[side == 2 ? 0 : side + 1])];
      const std::uint32_t k = local_[index(forming[side == 0 ? 2 : side - 1])];
      const Corner& p = corners_[i];
      const Corner& q = corners_[k];
      const Point r = corner(forming[side]).position;
      const Point s = corner(topology.forming(w)[topology.side_towards(w, v)]).position;
      const Bounded lift = bounded(estimated_lift(q.position, p.position, r, s));
      const Bounded shared = over(lift, doubled_area_[index(v)], doubled_area_[index(w)]) *
                             difference_of_squares(p, q);
      const double term = shared.error <= limit ? shared.value
                                                : edge_ratio(p.position, q.position, r, s) *
                                                      square_difference(x, p.position, q.position);
      sums_[i] += term;
      sums_[k] -= term;
      error += shared.error;
    }
  }
  return error;
}

void PlaneStolenAreas::see_corners(const Structure<2>& structure, const ConflictZone<2>& zone,
                                   Point x) {
  corners_.clear();
  local_.resize(structure.topology().point_limit());
  for (const auto& facet : zone.rim()) {
    const PointId p = begin_of(structure.topology(), facet);
    local_[index(p)] = static_cast<std::uint32_t>(corners_.size());
    const Point position = structure.position(p);
    const Point from_x{position.x - x.x, position.y - x.y};
    corners_.push_back({position, from_x, from_x.x * from_x.x + from_x.y * from_x.y, 0});
  }
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Corner& next = corners_[i + 1 < corners_.size() ? i + 1 : 0];
    corners_[i].doubled_area = doubled_area(x, corners_[i].position, next.position);
  }
}

void PlaneStolenAreas::mark_vertices(const Structure<2>& structure, const ConflictZone<2>& zone) {
  const Topology<2>& topology = structure.topology();
  if (mark_.size() < topology.size() || ++zone_number_ == 0) {
    mark_.assign(topology.size(), 0);
    doubled_area_.resize(topology.size());
    zone_number_ = 1;
  }
  for (const VertexId v : zone.vertices()) {
    const auto& forming = topology.forming(v);
    mark_[index(v)] = zone_number_;
    doubled_area_[index(v)] =
        doubled_area(structure.position(forming[0]), structure.position(forming[1]),
                     structure.position(forming[2]));
  }
}

void PlaneStolenAreas::find(const Structure<2>& structure, const ConflictZone<2>& zone, Point x,
                            std::vector<StolenArea>& areas) {
  see_corners(structure, zone, x);
  mark_vertices(structure, zone);
  const double error = add_all(structure, zone, x, HUGE_VAL);
  double total = 0;
  for (const double sum : sums_) total += sum;
  if (!(error <= largest_error * total)) {
    // The total itself may be wrong; then all terms are computed exactly. Else only those are whose
    // errors would add up to too much.
    const bool is_known = error <= total / 2;
    const double terms = 4 * static_cast<double>(corners_.size());
    add_all(structure, zone, x, is_known ? largest_error * total / 2 / terms : -1);
  }
  areas.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    areas.push_back({begin_of(structure.topology(), zone.rim()[i]), std::max(0.0, sums_[i] / 8)});
  }
}

}  // namespace thiessen
