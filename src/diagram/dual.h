#pragma once

#include <array>
#include <vector>

#include "tessellation/place.h"

namespace thiessen {

/// The whole border between the cells of two places, which nothing cuts off.
struct Border {
  PlaceIndex first;
  PlaceIndex second;
  double length;  ///< positive; infinite where the border never ends
};

/// A Delaunay triangle: three places whose cells meet at a vertex, counter-clockwise.
using DualTriangle = std::array<PlaceIndex, 3>;

/// What the Thiessen cells of some places say of the places: who borders whom, and over what
/// length, and which three meet at a vertex. Where cells of more than three places meet at one
/// vertex, it is one of the ways to divide these into triangles, and those of them whose cells only
/// touch there have no border. A pair has one border at most, its first place before its second;
/// pairs and triangles stand in rising order, and a triangle begins with its first place.
struct Dual {
  std::vector<DualTriangle> triangles;
  std::vector<Border> borders;
};

/// Puts a dual in the order that it has to have, and joins the borders of each pair. Cost: n log n.
void put_in_order(Dual& dual);

}  // namespace thiessen
