#include "map/sheet/map_drawing.h"

#include <algorithm>

#include "map/ink/ink.h"
#include "map/opencv/label_image.h"
#include "map/sheet/map_panel.h"

namespace thiessen {

std::size_t gauges_within(const StudyView& view) {
  const Extent& extent = view.extent;
  const auto is_within = [&](Point p) {
    return p.x >= extent.west && p.x <= extent.east && p.y >= extent.south && p.y <= extent.north;
  };
  return static_cast<std::size_t>(std::count_if(view.gauges.begin(), view.gauges.end(), is_within));
}

bool dots_would_cover(std::size_t gauges, double pixels) {
  constexpr double apart = 7;  // pixels between dots that have a pixel of ground round their rings
  return static_cast<double>(gauges) * apart * apart > pixels;
}

std::string note_of_crowd(std::size_t gauges) {
  return "not drawn: the " + std::to_string(gauges) + " gauges, too many for the map";
}

LabelCount draw_map(Canvas& canvas, const Page& page, const Picture& picture, StudyView& view,
                    const RainfallClasses& classes, const MapDetail& detail, Typesetter& type) {
  const PanelTransform transform(view.extent, page.panel);
  to_pixels(view, transform);
  const PixelBox sight = sight_box(view, transform, page.panel);
  const LabelImage basins = basin_labels(view, page.panel);
  Annotation annotation(canvas, page, picture, view, type);
  const LabelImage cells = cell_labels(view, page.panel, sight);
  draw_cells(canvas, page.panel, sight, picture, view, cells, classes, page.style.em);
  const std::size_t outlined =
      draw_outlines(canvas, page, sight, picture, view, cells, classes, detail);
  draw_isohyets(canvas, page, picture, view, sight);
  if (detail.has_gauges) annotation.draw_gauges();
  if (!page.style.bare) annotation.draw_levels();
  if (detail.has_labels) {
    constexpr std::size_t few = 40;
    const bool names_first = picture.basins.size() <= few;
    if (names_first && picture.basins.size() > 1) annotation.draw_basin_names(basins);
    annotation.draw_labels(pixels_of_gauges(picture, cells));
    if (!names_first) annotation.draw_basin_names(basins);
  }
  canvas.border(page.panel, ink::border, page.style.hairline);
  LabelCount count = annotation.count();
  count.cells = view.cells.size();
  count.outlined = outlined;
  return count;
}

}  // namespace thiessen
