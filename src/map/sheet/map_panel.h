#pragma once

#include <cstddef>
#include <vector>

#include "map/ink/canvas.h"
#include "map/ink/scanline.h"
#include "map/sheet/legend.h"
#include "map/sheet/page.h"
#include "map/sheet/picture.h"
#include "map/sheet/study_view.h"

namespace thiessen {

/// The owner of pixels in the panel's raster that lie in a basin and in no cell.
inline constexpr std::int32_t basin_without_cell = -2;

/// Takes the study from the map's plane to the panel's pixels: y runs down from the panel's upper
/// left.
void to_pixels(StudyView& view, const PanelTransform& transform);

/// Tells which cell each pixel of the panel belongs to: the cell's position in Picture::cells, or
/// `basin_without_cell`, or nobody. `basins` holds the raster of the basins, and is used up.
OwnerRaster cell_raster(const StudyView& view, OwnerRaster basins, const PixelBox& sight);

/// The part of the panel that the map fills: all of the panel, except for a map of the whole Earth.
PixelBox sight_box(const StudyView& view, const PanelTransform& transform, const PixelBox& panel);

/// Tells which basin each pixel of the panel belongs to.
OwnerRaster basin_raster(const StudyView& view, const PixelBox& panel);

/// Counts the pixels of each gauge's cells.
std::vector<std::size_t> pixels_of_gauges(const Picture& picture, const OwnerRaster& cells);

/// Fills the cells in the panel by rainfall, or by station in colours that differ between
/// neighbours.
void draw_cells(Canvas& canvas, const PixelBox& panel, const Picture& picture,
                const OwnerRaster& cells, const RainfallClasses& classes, int em);

/// Draws the outlines of cells, fainter where cells are small, and those of basins over them.
void draw_outlines(Canvas& canvas, const Page& page, const StudyView& view, const PixelBox& sight);

}  // namespace thiessen
