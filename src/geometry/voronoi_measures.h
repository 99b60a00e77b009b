#pragma once

#include "geometry/determinants.h"
#include "geometry/point.h"

namespace thiessen {

/// This file measures lengths and areas of Voronoi edges, each to a few times 2^-52 of itself,
/// however near the centres of circles and spheres are to each other, and however flat the
/// triangles and tetrahedra are: all cancellation is left to exact determinants. All functions
/// require coordinates in the exact range, in which nothing overflows.

/// The radius of the circle through a, b, c. It does not depend on their order, bit for bit.
/// Requires that they are not on one line.
double circumradius(Point a, Point b, Point c);
/// The radius of the sphere through a, b, c, d. It does not depend on their order, bit for bit.
/// Requires that they are not in one plane.
double circumradius(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                    const SpacePoint& d);

/// The area of the part of p's Voronoi cell that belongs to one edge: the triangle of p and the
/// edge between the cells of p and q, which ends at the centres of p, q, r and q, p, s. Requires
/// orientation(p, q, r) > 0, orientation(q, p, s) > 0, and in_circle(p, q, r, s) <= 0.
double sector_area(Point p, Point q, Point r, Point s);

/// The length of the edge between the Voronoi cells of p and q, divided by half the distance from p
/// to q. The edge goes from the centre of q, p, s to that of p, q, r, and the ratio is negative
/// where the centres lie in the other order.
///
/// With r to the left of p -> q and s to its right, the ratio is the sum of the cotangents of the
/// triangles' angles at r and at s. Where s is to the left too, its cotangent counts negative.
/// Requires that neither r nor s is on the line through p and q.
double edge_ratio(Point p, Point q, Point r, Point s);
/// The difference |from b|^2 - |from a|^2 of two squared distances.
double square_difference(Point from, Point a, Point b);

/// The Voronoi edge as a vector from the centre of p, q, r, s to that of p, q, s, t. Each component
/// is accurate to a few times 2^-52 of itself. Requires that both tetrahedra have positive
/// orientation, and in_sphere(p, q, r, s, t) <= 0.
SpaceVector<double> voronoi_edge(const SpacePoint& p, const SpacePoint& q, const SpacePoint& r,
                                 const SpacePoint& s, const SpacePoint& t);

/// The unit normal of the triangle, on the side from which a, b, c are seen counter-clockwise.
/// Requires that they are not on one line.
SpaceVector<double> unit_normal(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c);

}  // namespace thiessen
