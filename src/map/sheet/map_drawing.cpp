#include "map/sheet/map_drawing.h"

#include "map/ink/ink.h"
#include "map/opencv/label_image.h"
#include "map/sheet/map_panel.h"

namespace thiessen {

LabelCount draw_map(Canvas& canvas, const Page& page, const Picture& picture, StudyView& view,
                    const RainfallClasses& classes, const MapDetail& detail, Typesetter& type) {
  const PanelTransform transform(view.extent, page.panel);
  to_pixels(view, transform);
  const PixelBox sight = sight_box(view, transform, page.panel);
  const LabelImage basins = basin_labels(view, page.panel);
  Annotation annotation(canvas, page, picture, view, type);
  const LabelImage cells = cell_labels(view, page.panel, sight);
  draw_cells(canvas, page.panel, sight, picture, view, cells, classes, page.style.em);
  draw_outlines(canvas, page, view, sight);
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
  return annotation.count();
}

}  // namespace thiessen
