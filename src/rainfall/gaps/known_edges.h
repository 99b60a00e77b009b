#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "basin/basin.h"
#include "basin/ground_measure.h"

namespace thiessen {

/// What a measure says of each edge of some ground: edge by edge, ring by ring.
std::vector<double> figures_of_edges(const Basin& ground, const GroundMeasure& measure);

/// Measures the pieces of ground that is cut, most of whose edges stay whole: what those bear is
/// known, and only the others are measured. Whole edges are found as long as they come in their
/// order along the rings, as those of a CutBasin do; one that is not found is measured. For one
/// thread.
class KnownEdges : public GroundMeasure {
 public:
  /// `known` are the figures_of_edges, which may have been measured where the same ground has
  /// other coordinates. It and the measure must outlive this object.
  KnownEdges(const Basin& ground, std::span<const double> known, const GroundMeasure& measure);

  std::size_t figures() const override { return measure_.figures(); }
  void add(Point from, Point to, double bulge, std::span<double> figures) const override;

 private:
  struct Edge {
    Point from;
    Point to;
  };

  bool find(Point from, Point to) const;

  std::vector<Edge> edges_;
  std::span<const double> known_;
  const GroundMeasure& measure_;
  mutable std::size_t at_ = 0;  // the edge at which the last piece began that began at a corner
};

}  // namespace thiessen
