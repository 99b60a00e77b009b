#include "rainfall/plane_stolen_areas.h"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.h"
#include "geometry/voronoi_measures.h"

namespace thiessen {
namespace {

constexpr double u = 0x1p-53;
constexpr double largest_error = 2e-14;  // of what is taken

/// A number and a bound on its error.
struct Bounded {
  double value;
  double error;
};

/// Of an in-circle determinant whose vectors are rounded.
Bounded bounded(const Estimate& lift) {
  return {lift.value, 16 * u * lift.magnitude};
}

PlaneVector<Estimate> seen(Point v) {
  return {{v.x, std::abs(v.x)}, {v.y, std::abs(v.y)}};
}

}  // namespace

// Calls ratio.of_new(before, i, after), ratio.of_rim(i, next, third, area) and
// ratio.of_inner(p, q, r, s, left, right) for the edges.
template <typename Ratio>
double PlaneStolenAreas::add_all(const Structure<2>& structure, const ConflictZone<2>& zone,
                                 const Ratio& ratio) {
  const Topology<2>& topology = structure.topology();
  const std::size_t count = corners_.size();
  double error = 0;
  sums_.assign(count, 0);
  const auto add = [&](std::size_t p, std::size_t q, const Bounded& edge) {
    const Bounded difference = ratio.difference(corners_[p], corners_[q]);
    const double term = edge.value * difference.value;
    sums_[p] += term;
    sums_[q] -= term;
    error += 2 * (edge.error * std::abs(difference.value) +
                  std::abs(edge.value) * difference.error + 2 * u * std::abs(term));
  };
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i > 0 ? i - 1 : count - 1;
    const std::size_t after = i + 1 < count ? i + 1 : 0;
    const Bounded edge = ratio.of_new(corners_[before], corners_[i], corners_[after]);
    sums_[i] += edge.value * corners_[i].square;
    error += (edge.error + 4 * u * std::abs(edge.value)) * corners_[i].square;
    const auto& facet = zone.rim()[i];
    const Corner& third = corner(topology.forming(facet.inside)[facet.side]);
    add(i, after,
        ratio.of_rim(corners_[i], corners_[after], third, doubled_area_[index(facet.inside)]));
  }
  for (const VertexId v : zone.vertices()) {
    for (std::size_t side = 0; side < 3; ++side) {
      const VertexId w = topology.neighbour(v, side);
      if (w < v || mark_[index(w)] != zone_number_) continue;
      const auto& forming = topology.forming(v);
      const PointId p = forming[side == 2 ? 0 : side + 1];
      const PointId q = forming[side == 0 ? 2 : side - 1];
      const PointId s = topology.forming(w)[topology.side_towards(w, v)];
      add(local_[index(p)], local_[index(q)],
          ratio.of_inner(corner(p), corner(q), corner(forming[side]), corner(s),
                         doubled_area_[index(v)], doubled_area_[index(w)]));
    }
  }
  return error;
}

namespace {

/// In doubles.
struct QuickRatio {
  template <typename Corner>
  Bounded difference(const Corner& p, const Corner& q) const {
    const Point step{q.position.x - p.position.x, q.position.y - p.position.y};
    const double x = step.x * (p.from_x.x + q.from_x.x);
    const double y = step.y * (p.from_x.y + q.from_x.y);
    return {x + y, 4 * u *
                       (std::abs(x) + std::abs(y) +
                        (std::abs(step.x) + std::abs(step.y)) *
                            (std::sqrt(p.square) + std::sqrt(q.square)))};
  }
  static Bounded over(const Bounded& lift, double left, double right) {
    const double share = 1 / (left * right);
    return {lift.value * share, (lift.error + 64 * u * std::abs(lift.value)) * std::abs(share)};
  }
  template <typename Corner>
  Bounded of_new(const Corner& before, const Corner& p, const Corner& after) const {
    return over(
        bounded(determinant::in_circle(seen(before.from_x), seen(p.from_x), seen(after.from_x))),
        before.doubled_area, p.doubled_area);
  }
  template <typename Corner>
  Bounded of_rim(const Corner& p, const Corner& q, const Corner& third, double area) const {
    return over(bounded(determinant::in_circle(seen(p.from_x), seen(q.from_x), seen(third.from_x))),
                p.doubled_area, area);
  }
  template <typename Corner>
  Bounded of_inner(const Corner& p, const Corner& q, const Corner& r, const Corner& s, double left,
                   double right) const {
    Bounded lift = bounded(estimated_lift(p.position, q.position, r.position, s.position));
    lift.value = -lift.value;
    return over(lift, left, right);
  }
};

/// By exact determinants.
struct ExactRatio {
  Point x;

  template <typename Corner>
  Bounded difference(const Corner& p, const Corner& q) const {
    return {square_difference(x, p.position, q.position), 0};
  }
  template <typename Corner>
  Bounded of_new(const Corner& before, const Corner& p, const Corner& after) const {
    return {edge_ratio(x, p.position, after.position, before.position), 0};
  }
  template <typename Corner>
  Bounded of_rim(const Corner& p, const Corner& q, const Corner& third, double) const {
    return {edge_ratio(p.position, q.position, third.position, x), 0};
  }
  template <typename Corner>
  Bounded of_inner(const Corner& p, const Corner& q, const Corner& r, const Corner& s, double,
                   double) const {
    return {edge_ratio(p.position, q.position, r.position, s.position), 0};
  }
};

}  // namespace

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
  const double error = add_all(structure, zone, QuickRatio{});
  double total = 0;
  for (const double sum : sums_) total += sum;
  if (!(error <= largest_error * total)) add_all(structure, zone, ExactRatio{x});
  areas.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    areas.push_back({begin_of(structure.topology(), zone.rim()[i]), std::max(0.0, sums_[i] / 8)});
  }
}

}  // namespace thiessen
