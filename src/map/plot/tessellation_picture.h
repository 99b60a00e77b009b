#pragma once

#include <optional>
#include <vector>

#include "geometry/pixels.h"
#include "geometry/point.h"
#include "tessellation/number_of.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// The place from which one looks in space, and the place at which one looks.
struct View {
  SpacePoint view;
  SpacePoint site;
};

/// The part of a plane that a picture shows. Requires finite coordinates, and in each axis that
/// `low` is below `high`.
struct PlaneWindow {
  Point low;
  Point high;
};

/// The size of a tessellation's picture, within the limits of any picture (sheet/picture.h).
struct PlotSize {
  int width = 1600;          ///< pixels
  int height = 0;            ///< pixels; 0: as what is shown wants it
  int dots_to_the_inch = 0;  ///< what the picture tells a printer; 0: nothing
};

/// Draws a plane tessellation as a PNG file: Voronoi edges solid red, Delaunay edges dashed blue,
/// points with their numbers as far as these find room, axes. The points and a margin are in sight,
/// on equal scales; a needle's short side is stretched, and the picture says so. Unbounded edges
/// run off the panel. Of cocircular points the Delaunay edges that the rule for ties chooses are
/// drawn; Voronoi edges of no length are not.
///
/// With a window exactly that part is in sight, whether there are points in it or not: all edges
/// are cut at its border, and dots, numbers, axes and the width of lines are chosen for the points
/// within. A window more than 30 times as long as it is wide is stretched as a needle is.
///
/// The same points and numbers give the same bytes on one machine, whatever the locale and the
/// order in which the points came. Throws Error where no font is installed, memory runs out or
/// encoding fails. Cost: linear in the edges, and the pixels.
std::vector<unsigned char> plane_picture(const Tessellation<2>& tessellation,
                                         const NumberOf& number_of, ImageEncoder encoder,
                                         const std::optional<PlaneWindow>& window = {},
                                         const PlotSize& size = {});

/// Draws a tessellation in space as plane_picture draws one in the plane, in perspective: what is
/// far is fainter, thinner and smaller, and hidden by what is near. Unbounded edges end at a box
/// somewhat larger than the points' range, which is drawn with its coordinates. z points up, or y
/// where one looks along z. The site is the middle of the picture, and the box fills as much of the
/// picture as it can, up to a wide angle. Without a view one looks from outside a corner at the
/// middle of the points.
///
/// Where the points lie in a plane or on a line, Voronoi cells are prisms or slabs; their edges,
/// where there are any, and the rims at which they leave the box are drawn. Throws Error as
/// plane_picture does, and where view and site are one place or not finite, or the view is so far
/// off that it overflows in units of the points' range. Cost: linear in the edges, and sorting them
/// by depth.
std::vector<unsigned char> space_picture(const Tessellation<3>& tessellation,
                                         const NumberOf& number_of, ImageEncoder encoder,
                                         const std::optional<View>& view,
                                         const PlotSize& size = {});

}  // namespace thiessen
