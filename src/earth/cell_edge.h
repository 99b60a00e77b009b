#pragma once

#include "earth/bisector_arc.h"

namespace thiessen {

/// An edge between two cells, whose points are told by those of a great circle of the conformal
/// sphere, by the angle along it.
class CellEdge {
 public:
  explicit CellEdge(const BisectorArc& arc) : arc_(arc) {}
  virtual ~CellEdge() = default;

  const BisectorArc& arc() const { return arc_; }
  /// The edge's point across from the great circle's: longitude and latitude in degrees.
  virtual Point at(double angle) const = 0;
  /// How far the edge may be from the great circle, and more, in degrees.
  virtual double farthest_off() const = 0;

 private:
  BisectorArc arc_;
};

/// The edge that the conformal sphere itself has: the great circle.
class GreatCircleEdge : public CellEdge {
 public:
  using CellEdge::CellEdge;
  Point at(double angle) const override { return from_sphere(arc().at(angle)); }
  double farthest_off() const override { return 1e-3; }
};

}  // namespace thiessen
