#include "tessellation/audit.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/interrupt.h"
#include "tessellation/at_dimension.h"
#include "tessellation/id_table.h"
#include "tessellation/parity.h"

namespace thiessen {
namespace {

/// Checks one layer of a structure whose points span d dimensions, and collects the findings.
template <int Dimension, int d>
class Inspection {
 public:
  using Findings = std::vector<Finding<Dimension>>;
  using Simplex = typename Structure<Dimension>::template Simplex<d>;

  explicit Inspection(const Structure<Dimension>& structure)
      : structure_(structure), topology_(structure.topology()) {}

  Findings links() && {
    topology_.for_each_vertex([&](VertexId v) {
      throw_if_interrupted();
      inspect_points(v);
      for (std::size_t side = 0; side <= d; ++side) inspect_link(v, side);
    });
    if (!findings_.empty()) return findings_;
    inspect_simplices_of_points();
    inspect_pieces();
    return findings_;
  }

  Findings hull() && {
    VertexId outside = no_vertex;
    topology_.for_each_vertex([&](VertexId v) {
      throw_if_interrupted();
      if (topology_.is_infinite(v)) {
        inspect_hull_facet(v);
        outside = v;
      } else if (structure_.template orientation_of<d>(simplex(v)) <= 0) {
        find(Fault::simplex_turned_over, v);
      }
    });
    if (d > 1 && count_first_on_hull() != 1) find(Fault::hull_winds_again, outside);
    for (std::uint32_t i = 1; i < topology_.point_limit(); ++i) {
      if (topology_.is_there(PointId{i}) && d < Dimension &&
          structure_.is_off(position(PointId{i})))
        findings_.push_back({Fault::point_off_span, no_vertex, position(PointId{i})});
    }
    return findings_;
  }

  Findings spheres() && {
    topology_.for_each_vertex([&](VertexId v) {
      throw_if_interrupted();
      if (topology_.is_infinite(v)) return;
      for (std::size_t side = 0; side <= d; ++side) {
        const PointId across = point_across(v, side);
        if (across == infinite_point ||
            !structure_.template in_conflict<d>(simplex(v), position(across)))
          continue;
        find(is_tie(v, position(across)) ? Fault::tie_broken_otherwise : Fault::point_in_sphere, v);
      }
    });
    return findings_;
  }

 private:
  const PositionIn<Dimension>& position(PointId p) const { return structure_.position(p); }
  Simplex simplex(VertexId v) const { return structure_.template simplex<d>(v); }

  void find(Fault fault, VertexId v) {
    PositionIn<Dimension> place;
    for (const PointId p : topology_.forming(v)) {
      if (p != infinite_point && topology_.is_there(p)) place = position(p);
    }
    findings_.push_back({fault, v, place});
  }

  void inspect_points(VertexId v) {
    const Simplex points = simplex(v);
    for (std::size_t i = 0; i <= d; ++i) {
      const bool repeated = std::count(points.begin(), points.end(), points[i]) != 1;
      if (!repeated && topology_.is_there(points[i])) continue;
      find(Fault::repeated_forming_point, v);
      return;
    }
  }

  bool stands(VertexId v) const { return index(v) < topology_.size() && !topology_.is_free(v); }

  void inspect_link(VertexId v, std::size_t side) {
    const VertexId w = topology_.neighbour(v, side);
    if (!stands(w)) {
      find(Fault::link_to_nothing, v);
      return;
    }
    bool returned = false;
    for (std::size_t back = 0; back <= d; ++back) {
      if (topology_.neighbour(w, back) != v) continue;
      returned = true;
      // With w's point in place of v's own, this must be w's simplex turned over.
      Simplex turned = simplex(v);
      turned[side] = topology_.forming(w)[back];
      if (parity(turned, simplex(w)) == Parity::odd) return;
    }
    find(returned ? Fault::facet_not_shared : Fault::link_not_returned, v);
  }

  void inspect_simplices_of_points() {
    for (std::uint32_t i = 0; i < topology_.point_limit(); ++i) {
      const PointId p{i};
      if (!topology_.is_there(p)) continue;
      const VertexId v = topology_.vertex_of(p);
      if (!stands(v) || topology_.corner_of(v, p) == Topology<Dimension>::corners)
        findings_.push_back({Fault::point_without_simplex, v, position(p)});
    }
  }

  void inspect_pieces() {
    std::size_t simplices = 0;
    VertexId first = no_vertex;
    std::vector<bool> is_used(topology_.point_limit(), false);
    topology_.for_each_vertex([&](VertexId v) {
      if (simplices++ == 0) first = v;
      for (const PointId p : simplex(v)) is_used[index(p)] = true;
    });
    const auto points = static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), true));
    const bool as_many_as_should_be = d == 1   ? simplices == points
                                      : d == 2 ? simplices + 4 == 2 * points
                                               : count_edges() == points + simplices;
    if (points != topology_.count() + 1 || !as_many_as_should_be)
      find(Fault::number_of_simplices, first);
    if (count_reached(first) != simplices) find(Fault::in_pieces, first);
  }

  // Counts the edges. Where all simplices hang together and share their facets two by two, there
  // are as many edges as points and simplices together only if the neighbourhood of every point is
  // a sphere's.
  std::size_t count_edges() const {
    IdTable<2> edges;
    topology_.for_each_vertex([&](VertexId v) {
      throw_if_interrupted();
      for (std::size_t i = 0; i <= d; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const auto [low, high] = std::minmax(topology_.forming(v)[i], topology_.forming(v)[j]);
          edges.insert({static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high)}, 0);
        }
      }
    });
    return edges.size();
  }

  std::size_t count_reached(VertexId first) const {
    std::vector<bool> reached(topology_.size(), false);
    std::vector<VertexId> open{first};
    reached[index(first)] = true;
    std::size_t count = 0;
    while (!open.empty()) {
      throw_if_interrupted();
      const VertexId v = open.back();
      open.pop_back();
      ++count;
      for (std::size_t side = 0; side <= d; ++side) {
        const VertexId w = topology_.neighbour(v, side);
        if (reached[index(w)]) continue;
        reached[index(w)] = true;
        open.push_back(w);
      }
    }
    return count;
  }

  /// The forming point of v's neighbour at this side that v does not have.
  PointId point_across(VertexId v, std::size_t side) const {
    const VertexId w = topology_.neighbour(v, side);
    return topology_.forming(w)[topology_.side_towards(w, v)];
  }

  // Finds a fault where a facet of the hull has a point of a facet next to it on its outer side, as
  // a convex hull never has.
  void inspect_hull_facet(VertexId v) {
    const std::size_t infinite = topology_.corner_of(v, infinite_point);
    for (std::size_t side = 0; side <= d; ++side) {
      if (side == infinite) continue;
      const PointId across = point_across(v, side);
      if (structure_.template orientation_with<d>(simplex(v), infinite, position(across)) > 0)
        find(Fault::hull_not_convex, v);
    }
  }

  // Counts the hull's points that come, by coordinates, before all hull points next to them. A hull
  // that is convex everywhere has one such point each time it goes round.
  std::size_t count_first_on_hull() const {
    enum class Rank : std::uint8_t { inside, first, later };
    std::vector<Rank> rank(topology_.point_limit(), Rank::inside);
    topology_.for_each_vertex([&](VertexId v) {
      if (!topology_.is_infinite(v)) return;
      PointId least = infinite_point;
      for (const PointId p : simplex(v)) {
        if (p != infinite_point && (least == infinite_point || position(p) < position(least)))
          least = p;
      }
      for (const PointId p : simplex(v)) {
        if (p == infinite_point) continue;
        if (p != least) rank[index(p)] = Rank::later;
        if (p == least && rank[index(p)] == Rank::inside) rank[index(p)] = Rank::first;
      }
    });
    return static_cast<std::size_t>(std::count(rank.begin(), rank.end(), Rank::first));
  }

  // Whether q is on the circle or sphere of v's simplex itself, so that only a tie-break puts it
  // inside.
  bool is_tie(VertexId v, const PositionIn<Dimension>& q) const {
    const Simplex s = simplex(v);
    const auto at = [&](std::size_t i) -> const PositionIn<Dimension>& { return position(s[i]); };
    if constexpr (d == 1) {
      return false;
    } else if constexpr (d == 3) {
      return in_sphere(at(0), at(1), at(2), at(3), q) == 0;
    } else if constexpr (Dimension == 2) {
      return in_circle(at(0), at(1), at(2), q) == 0;
    } else {
      return in_circle_in_plane(structure_.dropped(), at(0), at(1), at(2), q) == 0;
    }
  }

  const Structure<Dimension>& structure_;
  const Topology<Dimension>& topology_;
  Findings findings_;
};

/// Whether the chain of free rows meets each free row once, and the count of points is the number
/// of those in use.
template <int Dimension>
bool has_sound_free_lists(const Topology<Dimension>& topology) {
  std::size_t used = 0;
  topology.for_each_vertex([&](VertexId) { ++used; });
  std::size_t free = 0;
  for (VertexId v = topology.state().first_free; v != no_vertex; v = topology.neighbour(v, 0)) {
    if (index(v) >= topology.size() || !topology.is_free(v) || ++free > topology.size())
      return false;
  }
  std::size_t points = 0;
  for (std::uint32_t i = 1; i < topology.point_limit(); ++i) {
    points += topology.is_there(PointId{i}) ? 1u : 0u;
  }
  const std::size_t rows = topology.dimension() < 0 ? 0 : topology.dimension() == 0 ? 2 : used;
  return used + free == topology.size() && points == topology.count() && used == rows;
}

}  // namespace

std::string_view name_of(Fault fault) {
  static constexpr std::array<std::string_view, 14> names{"rows or numbers free twice or lost",
                                                          "repeated forming point",
                                                          "link to nothing",
                                                          "link not returned",
                                                          "facet not shared",
                                                          "point without simplex",
                                                          "number of simplices",
                                                          "in pieces",
                                                          "simplex turned over",
                                                          "hull not convex",
                                                          "hull winds again",
                                                          "point off span",
                                                          "point in sphere",
                                                          "tie broken otherwise"};
  return names.at(static_cast<std::size_t>(fault));
}

template <int Dimension>
std::vector<Finding<Dimension>> audit_links(const Structure<Dimension>& structure) {
  return at_dimension<Dimension>(structure.topology().dimension(), [&](auto d) {
    return Inspection<Dimension, d>(structure).links();
  });
}

template <int Dimension>
std::vector<Finding<Dimension>> audit_hull(const Structure<Dimension>& structure) {
  return at_dimension<Dimension>(structure.topology().dimension(), [&](auto d) {
    return Inspection<Dimension, d>(structure).hull();
  });
}

template <int Dimension>
std::vector<Finding<Dimension>> audit_spheres(const Structure<Dimension>& structure) {
  return at_dimension<Dimension>(structure.topology().dimension(), [&](auto d) {
    return Inspection<Dimension, d>(structure).spheres();
  });
}

template <int Dimension>
std::vector<Finding<Dimension>> audit(const Structure<Dimension>& structure) {
  const Topology<Dimension>& topology = structure.topology();
  std::vector<Finding<Dimension>> findings;
  if (topology.dimension() > 0) findings = audit_links(structure);
  if (!has_sound_free_lists(topology))
    findings.push_back({Fault::free_twice_or_lost, no_vertex, {}});
  if (topology.dimension() < 1) return findings;
  if (findings.empty()) findings = audit_hull(structure);
  if (findings.empty()) findings = audit_spheres(structure);
  return findings;
}

template std::vector<Finding<2>> audit_links(const Structure<2>&);
template std::vector<Finding<3>> audit_links(const Structure<3>&);
template std::vector<Finding<2>> audit_hull(const Structure<2>&);
template std::vector<Finding<3>> audit_hull(const Structure<3>&);
template std::vector<Finding<2>> audit_spheres(const Structure<2>&);
template std::vector<Finding<3>> audit_spheres(const Structure<3>&);
template std::vector<Finding<2>> audit(const Structure<2>&);
template std::vector<Finding<3>> audit(const Structure<3>&);

}  // namespace thiessen
