#pragma once

#include <vector>

#include "tessellation/structure.h"

namespace thiessen {

/// What a new point deletes (section 2.2, step 1: LISTOFV): the vertices that are nearer to it than
/// to their own forming points, and the rim, which is the list of facets between these vertices and
/// the ones that are kept. In the plane the rim is in order, counter-clockwise.
///
/// Cost: in proportion to the vertices and their neighbours. Once the lists have grown, nothing is
/// allocated; in space they grow to one byte for every vertex of the structure.
template <int Dimension>
class ConflictZone {
 public:
  struct Facet {
    VertexId inside;
    VertexId outside;
    std::uint8_t side;          ///< the side of `inside` that the facet is
    std::uint8_t outside_side;  ///< the side of `outside` that the facet is
  };

  const std::vector<VertexId>& vertices() const { return vertices_; }
  const std::vector<Facet>& rim() const { return rim_; }

  /// Finds the conflict zone of a new point at q, starting from the vertex `first`. Requires d =
  /// the structure's dimension, and that `first` is in conflict with q.
  template <int d>
  void find(const Structure<Dimension>& structure, VertexId first, const PositionIn<Dimension>& q) {
    vertices_.assign(1, first);
    rim_.clear();
    if constexpr (d == 3) {
      search(structure, q);
    } else {
      walk_round<d>(structure, q);
    }
  }

 private:
  // On a line and in the plane no point lies inside the zone, so its vertices are linked like a
  // tree, and going round it meets each of them once.
  template <int d>
  void walk_round(const Structure<Dimension>& structure, const PositionIn<Dimension>& q) {
    const Topology<Dimension>& topology = structure.topology();
    open_.clear();
    for (std::size_t side = d + 1; side > 0; --side) {
      open_.push_back(Open(vertices_.front(), side - 1));
    }
    while (!open_.empty()) {
      const Open next = open_.back();
      open_.pop_back();
      const VertexId w = topology.neighbour(next.vertex(), next.side());
      const std::size_t entered = topology.side_towards(w, next.vertex());
      if (!structure.template in_conflict<d>(structure.template simplex<d>(w), q)) {
        rim_.push_back({next.vertex(), w, next.side(), static_cast<std::uint8_t>(entered)});
        continue;
      }
      vertices_.push_back(w);
      for (std::size_t turn = d; turn > 0; --turn) {
        open_.push_back(Open(w, (entered + turn) % (d + 1)));
      }
    }
  }

  void search(const Structure<Dimension>& structure, const PositionIn<Dimension>& q) {
    const Topology<Dimension>& topology = structure.topology();
    if (searching_) fate_.assign(fate_.size(), unknown);  // an exception left the last search
    searching_ = true;
    fate_.resize(topology.size(), unknown);
    fate_[index(vertices_.front())] = deleted;
    fetch_round(topology, vertices_.front());
    for (std::size_t next = 0; next < vertices_.size(); ++next) {
      const VertexId v = vertices_[next];
      for (const VertexId w : topology.row(v).neighbours) {
        for (const PointId p : topology.forming(w)) structure.fetch_position(p);
      }
      for (std::size_t side = 0; side <= Dimension; ++side) {
        const VertexId w = topology.neighbour(v, side);
        std::uint8_t& fate = fate_[index(w)];
        if (fate == unknown) {
          fate =
              structure.template in_conflict<Dimension>(structure.template simplex<Dimension>(w), q)
                  ? deleted
                  : kept;
          if (fate == deleted) {
            vertices_.push_back(w);
            fetch_round(topology, w);
          }
        }
        if (fate == kept) {
          rim_.push_back({v, w, static_cast<std::uint8_t>(side),
                          static_cast<std::uint8_t>(topology.side_towards(w, v))});
        }
      }
    }
    for (const VertexId v : vertices_) fate_[index(v)] = unknown;
    for (const Facet& f : rim_) fate_[index(f.outside)] = unknown;
    searching_ = false;
  }

  /// Prefetches what is to be looked at when the vertex's turn comes: places that are near each
  /// other in space may be far apart in memory.
  void fetch_round(const Topology<Dimension>& topology, VertexId v) const {
    for (const VertexId w : topology.row(v).neighbours) {
      topology.fetch(w);
      __builtin_prefetch(fate_.data() + index(w));
    }
  }

  /// A side of a vertex in the zone that is still to be looked at. It is packed into one number,
  /// because it is read again as soon as it is written.
  class Open {
   public:
    Open(VertexId v, std::size_t side) : packed_(std::uint64_t{index(v)} << 2 | side) {}
    VertexId vertex() const { return VertexId{static_cast<std::uint32_t>(packed_ >> 2)}; }
    std::uint8_t side() const { return packed_ & 3; }

   private:
    std::uint64_t packed_;
  };

  std::vector<VertexId> vertices_;
  std::vector<Facet> rim_;
  std::vector<Open> open_;
  static constexpr std::uint8_t unknown = 0, kept = 1, deleted = 2;
  std::vector<std::uint8_t> fate_;  // by vertex, used in space; unknown between searches
  bool searching_ = false;
};

}  // namespace thiessen
