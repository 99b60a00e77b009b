#pragma once

#include <string>
#include <vector>

#include "map/ink/canvas.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/page.h"
#include "map/sheet/study_view.h"

namespace thiessen {

/// The scale bar: its length on the ground, in figures, and in pixels.
struct ScaleBar {
  RoundValue length;  ///< in `unit`
  std::string unit;   ///< "km", "m", or "units" where the plane's unit is unknown
  double pixels = 0;
};

/// The scale bar of the longest round length that takes at most `longest` pixels at the map's
/// centre. Where the length of the plane's unit is unknown, `metres_per_unit` is NaN, and the bar
/// counts plain units.
ScaleBar scale_bar(double pixels_per_unit, double metres_per_unit, double longest);

/// Draws scale bar, north arrow and notes below the map, side by side. Returns the notes that find
/// no room and are left out.
std::vector<std::string> draw_footer(Canvas& canvas, const Page& page, const StudyView& view,
                                     double pixels_per_unit, bool north_is_up,
                                     const std::string& labels_note, Typesetter& type);

}  // namespace thiessen
