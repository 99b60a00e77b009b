#pragma once

#include "geometry/determinants.h"
#include "geometry/point.h"

namespace thiessen {

/// Lengths round the centres of circles and spheres, each to a few times 2^-52 of itself, however
/// near the centres are to each other or how flat the triangles and tetrahedra: cancellation is
/// left to exact determinants. All require coordinates in the exact range, in which nothing
/// overflows.

/// The radius of the circle through a, b, c, which does not depend on their order, bit for bit.
/// Requires that they are not on one line.
double circumradius(Point a, Point b, Point c);
/// The radius of the sphere through a, b, c, d, which does not depend on their order, bit for bit.
/// Requires that they are not in one plane.
double circumradius(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                    const SpacePoint& d);

/// The area of the triangle of p and the edge between its Voronoi cell and q's, which ends at the
/// centres of p, q, r and q, p, s. Requires orientation(p, q, r) > 0, orientation(q, p, s) > 0, and
/// in_circle(p, q, r, s) <= 0.
double sector_area(Point p, Point q, Point r, Point s);

/// The length of the edge between the Voronoi cells of p and q, from the centre of q, p, s to that
/// of p, q, r, over half the distance from p to q: the cotangents of the angles at r and at s,
/// added up, where r is to the left of p -> q and s to its right; negative where the centres lie in
/// the other order. Where s is to the left too its cotangent counts negative. Requires that neither
/// three are on one line.
double edge_ratio(Point p, Point q, Point r, Point s);
/// |from b|^2 - |from a|^2.
double square_difference(Point from, Point a, Point b);

/// The Voronoi edge from the centre of p, q, r, s to that of p, q, s, t, each component to a few
/// times 2^-52 of itself. Requires positive orientation of both tetrahedra, and
/// in_sphere(p, q, r, s, t) <= 0.
SpaceVector<double> voronoi_edge(const SpacePoint& p, const SpacePoint& q, const SpacePoint& r,
                                 const SpacePoint& s, const SpacePoint& t);

/// The direction, of length 1, from which a, b, c are seen counter-clockwise. Requires that they
/// are not on one line.
SpaceVector<double> unit_normal(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c);

}  // namespace thiessen
