#pragma once

#include <cstddef>
#include <vector>

#include "map/ink/canvas.h"
#include "map/opencv/label_image.h"
#include "map/sheet/legend.h"
#include "map/sheet/map_detail.h"
#include "map/sheet/page.h"
#include "map/sheet/picture.h"
#include "map/sheet/study_view.h"

namespace thiessen {

/// Takes the study from the map's plane to the panel's pixels: y runs down from the panel's upper
/// left.
void to_pixels(StudyView& view, const PanelTransform& transform);

/// The part of the panel that the map fills: all of the panel, except for a map of the whole Earth.
PixelBox sight_box(const StudyView& view, const PanelTransform& transform, const PixelBox& panel);

/// Tells which basin each pixel of the panel shows.
LabelImage basin_labels(const StudyView& view, const PixelBox& panel);

/// Tells which cell each pixel of the panel shows: its position in Picture::cells, nobody out of
/// sight.
LabelImage cell_labels(const StudyView& view, const PixelBox& panel, const PixelBox& sight);

/// Counts the pixels of each gauge's cells.
std::vector<std::size_t> pixels_of_gauges(const Picture& picture, const LabelImage& cells);

/// Draws the lines of equal rainfall, each level in a group of its own.
void draw_isohyets(Canvas& canvas, const Page& page, const Picture& picture, const StudyView& view,
                   const PixelBox& sight);

/// Fills the cells in the panel by rainfall, or a surface's bands in their place, or cells by
/// station in colours that differ between neighbours. By rainfall, cells without a reading are
/// hatched, and so is what of a basin is in no cell.
void draw_cells(Canvas& canvas, const PixelBox& panel, const PixelBox& sight,
                const Picture& picture, const StudyView& view, const LabelImage& cells,
                const RainfallClasses& classes, int em);

/// Draws the outlines of cells, unless a surface is shown, and those of basins over them, fainter
/// where these are small, as far as there is room for them, and returns how many cells have one:
/// `cells` tells how large each is in pixels, and those of a few have none. On dark ground cells
/// have light outlines, and those of basins with such ground have a light rim.
std::size_t draw_outlines(Canvas& canvas, const Page& page, const PixelBox& sight,
                          const Picture& picture, const StudyView& view, const LabelImage& cells,
                          const RainfallClasses& classes, const MapDetail& detail);

}  // namespace thiessen
