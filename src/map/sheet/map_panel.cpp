#include "map/sheet/map_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/interrupt.h"
#include "map/ink/ink.h"
#include "map/ink/signs.h"
#include "map/sheet/palette.h"

namespace thiessen {
namespace {

/// The pairs of gauges whose cells touch in the raster of pixels.
TouchingPairs touching_gauges(const Picture& picture, const LabelImage& cells) {
  TouchingPairs pairs;
  const auto gauge_of = [&](std::int32_t cell) {
    return static_cast<std::uint32_t>(picture.cells[static_cast<std::size_t>(cell)].gauge);
  };
  const auto touch = [&](std::int32_t a, std::int32_t b) {
    if (a != b && a >= 0 && b >= 0) pairs.add(gauge_of(a), gauge_of(b));
  };
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      if (x + 1 < cells.width()) touch(cells.at(x, y), cells.at(x + 1, y));
      if (y + 1 < cells.height()) touch(cells.at(x, y), cells.at(x, y + 1));
    }
  }
  return pairs;
}

std::size_t gauge_count(const Picture& picture) {
  std::size_t count = picture.gauges.size();
  for (const PictureCell& cell : picture.cells) count = std::max(count, cell.gauge + 1);
  return count;
}

/// The colour of each cell by station.
std::vector<Colour> station_colours(const Picture& picture, const LabelImage& cells) {
  const auto palette = categorical_colours();
  const std::vector<std::uint8_t> chosen = colour_neighbours(
      gauge_count(picture), touching_gauges(picture, cells).pairs(), palette.size());
  std::vector<Colour> colours;
  for (const PictureCell& cell : picture.cells) colours.push_back(palette[chosen[cell.gauge]]);
  return colours;
}

/// The colour of each cell by rainfall. Cells without a reading have no class, and get the plain
/// grey.
std::vector<Colour> rainfall_colours(const Picture& picture, const RainfallClasses& classes) {
  std::vector<Colour> colours;
  for (const PictureCell& cell : picture.cells) {
    colours.push_back(std::isfinite(cell.rainfall) ? classes.colour(cell.rainfall)
                                                   : ink::no_reading);
  }
  return colours;
}

void clear_outside(LabelImage& labels, const PixelBox& box) {
  std::size_t i = 0;
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x, ++i) {
      const bool inside = x >= box.x && x < box.right() && y >= box.y && y < box.bottom();
      if (!inside) labels.labels()[i] = LabelImage::nobody;
    }
  }
}

/// The part of the page in which the map is drawn, with coordinates from the panel's upper left.
Window window_of(const PixelBox& panel, const PixelBox& sight) {
  return {{panel.x + sight.x, panel.y + sight.y, sight.width, sight.height},
          {static_cast<double>(panel.x), static_cast<double>(panel.y)}};
}

Area area_of(const MapShape& shape, Colour colour, const Mark& mark) {
  Area area{{}, colour, false, mark};
  for (const MapPart& part : shape) area.parts.push_back(part.rings);
  return area;
}

std::string_view name_of(const Picture& picture, std::size_t basin) {
  return basin < picture.basins.size() ? std::string_view(picture.basins[basin].name)
                                       : std::string_view();
}

std::string_view id_of(const Picture& picture, std::size_t gauge) {
  return gauge < picture.gauges.size() ? std::string_view(picture.gauges[gauge].station)
                                       : std::string_view();
}

void add_lines(const MapShape& shape, std::vector<Polyline>& lines) {
  for (const MapPart& part : shape) lines.insert(lines.end(), part.lines.begin(), part.lines.end());
}

std::vector<Polyline> lines_of(const std::vector<MapShape>& shapes) {
  std::vector<Polyline> lines;
  for (const MapShape& shape : shapes) add_lines(shape, lines);
  return lines;
}

/// The colours of the ground under outlines. Ground by station is pale and has none.
std::vector<Colour> grounds_of(const Picture& picture, const RainfallClasses& classes) {
  if (!picture.by_rainfall) return {};
  if (picture.bands.empty()) return rainfall_colours(picture, classes);
  std::vector<Colour> colours;
  for (const PictureBand& band : picture.bands) colours.push_back(classes.colour(band.rainfall));
  return colours;
}

/// The outlines of basins in which there is ground as dark as these: of a surface, of all.
std::vector<Polyline> lines_on_dark(const Picture& picture, const StudyView& view,
                                    const std::vector<Colour>& grounds) {
  std::vector<bool> is_dark(view.basins.size(), false);
  for (std::size_t i = 0; i < grounds.size(); ++i) {
    if (!hides_basin_edge(grounds[i])) continue;
    if (!picture.bands.empty()) return lines_of(view.basins);
    const std::size_t basin = picture.cells[i].basin;
    if (basin < is_dark.size()) is_dark[basin] = true;
  }
  std::vector<Polyline> lines;
  for (std::size_t i = 0; i < view.basins.size(); ++i) {
    if (is_dark[i]) add_lines(view.basins[i], lines);
  }
  return lines;
}

constexpr double ample = 14;  // pixels: the side of a shape that no line hides anything of

/// The share of its opacity that the line round shapes of this side in pixels has.
double faded(double side) {
  return std::clamp(side / ample, 0.3, 1.0);
}

/// Draws outlines as strongly as suits cells of this side in pixels.
void draw(Canvas& canvas, const std::vector<Polyline>& outlines, double side, Stroke stroke, int em,
          const Window& window) {
  if (outlines.empty()) return;
  stroke.alpha =
      static_cast<int>(stroke.alpha * faded(side) * std::clamp(0.35 + 0.8 * side / em, 0.35, 1.0));
  canvas.lines(outlines, stroke, window);
}

std::vector<std::size_t> pixels_of_cells(const LabelImage& labels, std::size_t count) {
  std::vector<std::size_t> pixels(count, 0);
  for (const std::int32_t cell : labels.labels()) {
    if (cell >= 0) ++pixels[static_cast<std::size_t>(cell)];
  }
  return pixels;
}

/// Draws the outlines of cells that are more than a few pixels wide, and returns how many these
/// are. No line is stronger than suits the cells of middling size. Light ones come first, so that
/// between dark and pale ground there is the dark line, and faint ones of small cells before those
/// of larger ones beside them.
std::size_t draw_cell_outlines(Canvas& canvas, const StudyView& view, const LabelImage& labels,
                               const std::vector<Colour>& grounds, int em, const Window& window) {
  constexpr double least = 5 * 5;  // pixels
  const std::vector<std::size_t> pixels = pixels_of_cells(labels, view.cells.size());
  std::array<std::vector<Polyline>, 2> on_dark;  // of small cells, and of those of ample size
  std::array<std::vector<Polyline>, 2> on_pale;
  std::array<std::size_t, 2> count{};
  std::array<double, 2> sum{};  // of pixels
  for (std::size_t i = 0; i < view.cells.size(); ++i) {
    const auto size = static_cast<double>(pixels[i]);
    if (size < least && view.cells.size() > 1) continue;
    const bool is_dark = i < grounds.size() && cell_stroke(em, grounds[i]).colour == ink::white;
    const std::size_t group = size < ample * ample ? 0 : 1;
    add_lines(view.cells[i], (is_dark ? on_dark : on_pale)[group]);
    ++count[group];
    sum[group] += size;
  }
  const std::size_t all = count[0] + count[1];
  const std::array<double, 2> sides{side_of_each(count[0], sum[0]),
                                    side_of_each(all, sum[0] + sum[1])};
  for (std::size_t group = 0; group < 2; ++group)
    draw(canvas, on_dark[group], sides[group], cell_stroke(em, {0, 0, 0}), em, window);
  for (std::size_t group = 0; group < 2; ++group)
    draw(canvas, on_pale[group], sides[group], cell_stroke(em, ink::white), em, window);
  return all;
}

}  // namespace

void to_pixels(StudyView& view, const PanelTransform& transform) {
  const auto move = [&](std::vector<MapShape>& shapes) {
    for (MapShape& shape : shapes) {
      for (MapPart& part : shape) {
        for (auto* lists : {&part.rings, &part.lines}) {
          for (std::vector<Point>& list : *lists) {
            for (Point& p : list) p = transform(p);
          }
        }
      }
    }
  };
  move(view.cells);
  move(view.bands);
  move(view.basins);
  for (auto& level : view.isohyets) {
    for (std::vector<Point>& line : level) {
      for (Point& p : line) p = transform(p);
    }
  }
  for (Point& p : view.gauges) p = transform(p);
}

LabelImage basin_labels(const StudyView& view, const PixelBox& panel) {
  LabelImage labels(panel.width, panel.height);
  for (std::size_t i = 0; i < view.basins.size(); ++i) {
    for (const MapPart& part : view.basins[i]) labels.fill(part.rings, static_cast<int>(i));
  }
  return labels;
}

PixelBox sight_box(const StudyView& view, const PanelTransform& transform, const PixelBox& panel) {
  if (view.projection.period() == 0) return {0, 0, panel.width, panel.height};
  const Point upper = transform({view.extent.west, view.extent.north});
  const Point lower = transform({view.extent.east, view.extent.south});
  const auto pixel = [](double p, int most) {
    return static_cast<int>(std::clamp(std::round(p), 0.0, static_cast<double>(most)));
  };
  const int x = pixel(upper.x, panel.width);
  const int y = pixel(upper.y, panel.height);
  return {x, y, pixel(lower.x, panel.width) - x, pixel(lower.y, panel.height) - y};
}

LabelImage cell_labels(const StudyView& view, const PixelBox& panel, const PixelBox& sight) {
  LabelImage labels(panel.width, panel.height);
  for (std::size_t i = 0; i < view.cells.size(); ++i) {
    for (const MapPart& part : view.cells[i]) labels.fill(part.rings, static_cast<int>(i));
  }
  clear_outside(labels, sight);
  return labels;
}

std::vector<std::size_t> pixels_of_gauges(const Picture& picture, const LabelImage& cells) {
  std::vector<std::size_t> pixels(gauge_count(picture), 0);
  for (const std::int32_t owner : cells.labels()) {
    if (owner >= 0) ++pixels[picture.cells[static_cast<std::size_t>(owner)].gauge];
  }
  return pixels;
}

void draw_cells(Canvas& canvas, const PixelBox& panel, const PixelBox& sight,
                const Picture& picture, const StudyView& view, const LabelImage& cells,
                const RainfallClasses& classes, int em) {
  const std::vector<Colour> colours =
      picture.by_rainfall ? rainfall_colours(picture, classes) : station_colours(picture, cells);
  std::vector<Area> areas;
  for (std::size_t i = 0; picture.by_rainfall && i < view.basins.size(); ++i) {
    areas.push_back(area_of(view.basins[i], ink::no_reading, {"basin", {}, name_of(picture, i)}));
    areas.back().hatched = true;
  }
  for (std::size_t i = 0; i < view.bands.size(); ++i) {
    throw_if_interrupted();
    const Colour colour = classes.colour(picture.bands[i].rainfall);
    areas.push_back(area_of(view.bands[i], colour, {"surface"}));
  }
  for (std::size_t i = 0; view.bands.empty() && i < view.cells.size(); ++i) {
    throw_if_interrupted();
    const PictureCell& cell = picture.cells[i];
    const Mark mark{"cell", id_of(picture, cell.gauge), name_of(picture, cell.basin)};
    areas.push_back(area_of(view.cells[i], colours[i], mark));
    areas.back().hatched = picture.by_rainfall && !std::isfinite(cell.rainfall);
  }
  const Group group(canvas, {"cells"});
  canvas.fill(panel, ink::background);
  canvas.areas(areas, hatching(em), window_of(panel, sight));
}

std::size_t draw_outlines(Canvas& canvas, const Page& page, const PixelBox& sight,
                          const Picture& picture, const StudyView& view, const LabelImage& cells,
                          const RainfallClasses& classes, const MapDetail& detail) {
  constexpr int basin_alpha = 230;
  constexpr double line_to_side = 0.09;
  const PixelBox& panel = page.panel;
  const int em = page.style.em;
  const double pixels = static_cast<double>(panel.width) * panel.height;
  const double basin = side_of_each(view.basins.size(), pixels);
  const std::vector<Colour> grounds = grounds_of(picture, classes);
  const Group group(canvas, {"outlines"});
  const Window window = window_of(panel, sight);
  std::size_t outlined = 0;
  if (view.bands.empty() && detail.has_cell_outlines)
    outlined = draw_cell_outlines(canvas, view, cells, grounds, em, window);
  if (!detail.has_basin_outlines) return outlined;
  constexpr std::size_t many = 200;
  const double thinner = view.basins.size() > many ? 0.6 : 1.0;
  const double wide = std::max(1.2, basin_line_width(em) * thinner);
  const double width = std::min(wide, std::max(0.8, line_to_side * basin));
  const std::vector<Polyline> on_dark = lines_on_dark(picture, view, grounds);
  if (!on_dark.empty()) {
    Stroke rim = basin_rim(em, width);
    rim.alpha = static_cast<int>(rim.alpha * faded(basin));
    canvas.lines(on_dark, rim, window);
  }
  const int alpha = static_cast<int>(basin_alpha * faded(basin));
  canvas.lines(lines_of(view.basins), {ink::basin_edge, width, alpha}, window);
  return outlined;
}

void draw_isohyets(Canvas& canvas, const Page& page, const Picture& picture, const StudyView& view,
                   const PixelBox& sight) {
  constexpr int casing_alpha = 190;
  const double width = isohyet_line_width(page.style.em);
  const Window window = window_of(page.panel, sight);
  for (std::size_t i = 0; i < view.isohyets.size(); ++i) {
    const std::vector<Polyline> lines(view.isohyets[i].begin(), view.isohyets[i].end());
    const Group group(canvas, {.kind = "isohyet", .level = picture.isohyets[i].level});
    canvas.lines(lines, {ink::white, 2.4 * width, casing_alpha}, window);
    canvas.lines(lines, {ink::isohyet, width}, window);
  }
}

}  // namespace thiessen
