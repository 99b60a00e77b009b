#pragma once

#include "map/ink/canvas.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/annotation.h"
#include "map/sheet/page.h"
#include "map/sheet/picture.h"
#include "map/sheet/study_view.h"

namespace thiessen {

/// What is drawn on a map beside its cells and basins.
struct MapDetail {
  bool has_gauges = true;
  bool has_labels = true;  ///< of gauges and of basins
};

/// Draws one map into the page's panel: cells, outlines, gauges, names and labels. `view` is on the
/// map's plane, and its shapes are in pixels of the panel afterwards. Returns how many gauges and
/// labels found room.
LabelCount draw_map(Canvas& canvas, const Page& page, const Picture& picture, StudyView& view,
                    const RainfallClasses& classes, const MapDetail& detail, Typesetter& type);

}  // namespace thiessen
