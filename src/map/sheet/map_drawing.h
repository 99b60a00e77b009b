#pragma once

#include <cstddef>
#include <string>

#include "map/ink/canvas.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/annotation.h"
#include "map/sheet/map_detail.h"
#include "map/sheet/page.h"
#include "map/sheet/picture.h"
#include "map/sheet/study_view.h"

namespace thiessen {

/// How many gauges lie within the extent of a view on the map's plane.
std::size_t gauges_within(const StudyView& view);

/// Whether the dots of so many gauges would cover a map of so many pixels, as thousands do: each
/// has less room than the smallest dot with its ring takes.
bool dots_would_cover(std::size_t gauges, double pixels);

/// Words that gauges are not drawn.
std::string note_of_crowd(std::size_t gauges);

/// Draws one map into the page's panel: cells, outlines, gauges, names and labels. `view` is on the
/// map's plane, and its shapes are in pixels of the panel afterwards. Returns how many gauges and
/// labels found room.
LabelCount draw_map(Canvas& canvas, const Page& page, const Picture& picture, StudyView& view,
                    const RainfallClasses& classes, const MapDetail& detail, Typesetter& type);

}  // namespace thiessen
