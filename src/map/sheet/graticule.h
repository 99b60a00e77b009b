#pragma once

#include <functional>
#include <string>
#include <vector>

#include "map/ink/canvas.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/page.h"
#include "map/sheet/study_view.h"

namespace thiessen {

/// A round coordinate that meets the map's frame.
struct FrameTick {
  double at = 0;  ///< in pixels along the edge
  std::string text;
};

/// What a coordinate along an edge is: of a plane, or degrees east or north.
enum class FrameAxis { plane, longitude, latitude };

/// The round values that a coordinate takes along an edge of `length` pixels, at most about `most`
/// of them, all with the same number of decimals; `value(pixel)` is the coordinate there. An edge
/// on which the coordinate is not finite has none.
std::vector<FrameTick> frame_ticks(const std::function<double(double)>& value, double length,
                                   int most, FrameAxis axis);

/// The edges of a map that have coordinates.
struct FrameEdges {
  bool lower = true;
  bool left = true;
};

/// Draws coordinates along these edges of the panel, with a tick at each.
void draw_graticule(Canvas& canvas, const Page& page, const StudyView& view,
                    const PanelTransform& transform, const FrameEdges& edges, Typesetter& type);

}  // namespace thiessen
