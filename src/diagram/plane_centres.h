#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "geometry/point.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// The circumcentres of a tessellation's simplices. Cocircular simplices have one centre. So have
/// neighbouring simplices whose centres rounding cannot tell apart, because an edge so short could
/// point in any direction. A group of such simplices is known by the number of one of them.
class PlaneCentres {
 public:
  /// Requires points that span the plane. The tessellation must outlive this object, and not
  /// change. Where `is_needed` has an entry for each number of a point, there are centres only for
  /// simplices with two corners that are needed, the same as if all were. Cost: linear in those.
  explicit PlaneCentres(const Tessellation<2>& tessellation,
                        const std::vector<bool>& is_needed = {});

  std::uint32_t group_of(VertexId v) { return groups_.find(index(v)); }
  Point of(VertexId v) const { return centre_[index(v)]; }

 private:
  /// What is known of a simplex: nothing, its centre and with whom it is cocircular, or that its
  /// centre is asked for, and so that of each that might be one with it.
  enum class Known : std::uint8_t { nothing, alone, asked };

  template <typename IsAsked>
  bool find_distinct(const IsAsked& is_asked);
  template <typename IsAsked>
  void find_groups(const IsAsked& is_asked);
  void find_cocircular(VertexId v, Known known);
  void ask_cocircular(VertexId v);
  void unite_indistinct(VertexId v);
  void compute_united();
  VertexId first_of(const std::vector<VertexId>& simplices) const;
  bool are_cocircular(VertexId v, VertexId w) const;
  bool are_indistinct(VertexId v, VertexId w, double roundings = 4) const;
  double rounding(VertexId v) const;
  Point centre_of(VertexId v) const;
  std::array<Point, 3> corners_of(VertexId v) const;
  Point position(PointId p) const { return tessellation_.position(p); }

  const Tessellation<2>& tessellation_;
  const Topology<2>& topology_;
  DisjointSets groups_;
  std::vector<Point> centre_;
  std::vector<Known> known_;
  std::vector<VertexId> group_;        // at hand
  std::vector<VertexId> newly_asked_;  // those whose neighbours are still to be compared
  bool any_indistinct_ = false;
};

}  // namespace thiessen
