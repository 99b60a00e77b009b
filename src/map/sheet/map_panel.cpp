#include "map/sheet/map_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "map/ink/ink.h"
#include "map/ink/signs.h"
#include "map/ink/stroke.h"
#include "map/sheet/palette.h"

namespace thiessen {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

void sort_out(std::vector<Pair>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// The pairs of gauges whose cells touch in the raster of pixels. Memory does not grow with the
/// pixels.
std::vector<Pair> touching_gauges(const Picture& picture, const OwnerRaster& cells) {
  std::vector<Pair> pairs;
  std::size_t most = 1'000'000;
  const auto touch = [&](std::int32_t a, std::int32_t b) {
    if (a == b || a < 0 || b < 0) return;
    const auto i = static_cast<std::uint32_t>(picture.cells[static_cast<std::size_t>(a)].gauge);
    const auto j = static_cast<std::uint32_t>(picture.cells[static_cast<std::size_t>(b)].gauge);
    const Pair pair = std::minmax(i, j);
    if (i == j || (!pairs.empty() && pairs.back() == pair)) return;
    pairs.push_back(pair);
    if (pairs.size() < most) return;
    sort_out(pairs);
    most = std::max(most, 2 * pairs.size());
  };
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      if (x + 1 < cells.width()) touch(cells.at(x, y), cells.at(x + 1, y));
      if (y + 1 < cells.height()) touch(cells.at(x, y), cells.at(x, y + 1));
    }
  }
  sort_out(pairs);
  return pairs;
}

std::size_t gauge_count(const Picture& picture) {
  std::size_t count = picture.gauges.size();
  for (const PictureCell& cell : picture.cells) count = std::max(count, cell.gauge + 1);
  return count;
}

/// The colour of each cell by station.
std::vector<Colour> station_colours(const Picture& picture, const OwnerRaster& cells) {
  const auto palette = categorical_colours();
  const std::vector<std::uint8_t> chosen =
      colour_neighbours(gauge_count(picture), touching_gauges(picture, cells), palette.size());
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

template <typename T>
void clear_outside(std::span<T> pixels, int width, const PixelBox& box, T nothing) {
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const int x = static_cast<int>(i % static_cast<std::size_t>(width));
    const int y = static_cast<int>(i / static_cast<std::size_t>(width));
    const bool inside = x >= box.x && x < box.right() && y >= box.y && y < box.bottom();
    if (!inside) pixels[i] = nothing;
  }
}

void cover(Coverage& layer, const std::vector<MapShape>& shapes, double line_width) {
  for (const MapShape& shape : shapes) {
    for (const MapPart& part : shape) {
      for (const auto& line : part.lines) stroke(layer, line, line_width);
    }
  }
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
  move(view.basins);
  for (Point& p : view.gauges) p = transform(p);
}

OwnerRaster basin_raster(const StudyView& view, const PixelBox& panel) {
  OwnerRaster raster(panel.width, panel.height);
  for (std::size_t i = 0; i < view.basins.size(); ++i) {
    for (const MapPart& part : view.basins[i]) raster.fill(part.rings, static_cast<int>(i));
  }
  return raster;
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

OwnerRaster cell_raster(const StudyView& view, OwnerRaster basins, const PixelBox& sight) {
  for (std::int32_t& owner : basins.owners()) {
    if (owner != OwnerRaster::nobody) owner = basin_without_cell;
  }
  for (std::size_t i = 0; i < view.cells.size(); ++i) {
    for (const MapPart& part : view.cells[i]) basins.fill(part.rings, static_cast<int>(i));
  }
  clear_outside(basins.owners(), basins.width(), sight, OwnerRaster::nobody);
  return basins;
}

std::vector<std::size_t> pixels_of_gauges(const Picture& picture, const OwnerRaster& cells) {
  std::vector<std::size_t> pixels(gauge_count(picture), 0);
  for (const std::int32_t owner : cells.owners()) {
    if (owner >= 0) ++pixels[picture.cells[static_cast<std::size_t>(owner)].gauge];
  }
  return pixels;
}

void draw_cells(Canvas& canvas, const PixelBox& panel, const Picture& picture,
                const OwnerRaster& cells, const RainfallClasses& classes, int em) {
  const std::vector<Colour> colours =
      picture.by_rainfall ? rainfall_colours(picture, classes) : station_colours(picture, cells);
  for (int y = 0; y < panel.height; ++y) {
    for (int x = 0; x < panel.width; ++x) {
      const std::int32_t owner = cells.at(x, y);
      Colour colour = ink::background;
      if (owner >= 0) colour = colours[static_cast<std::size_t>(owner)];
      const bool unread =
          owner == basin_without_cell ||
          (owner >= 0 && !std::isfinite(picture.cells[static_cast<std::size_t>(owner)].rainfall));
      if (picture.by_rainfall && unread) colour = hatching(panel.x + x, panel.y + y, em);
      canvas.set(panel.x + x, panel.y + y, colour);
    }
  }
}

void draw_outlines(Canvas& canvas, const Page& page, const StudyView& view, const PixelBox& sight) {
  const PixelBox& panel = page.panel;
  const int em = page.style.em;
  const double share = static_cast<double>(panel.width) * panel.height /
                       std::max(1.0, static_cast<double>(view.cells.size()));
  const double cell_size = std::sqrt(share) / em;  // side of a cell of mean size, in ems
  const int alpha = static_cast<int>(std::clamp(70 + 160 * cell_size, 70.0, 200.0));
  Coverage layer(panel.width, panel.height);
  cover(layer, view.cells, cell_line_width(em));
  clear_outside(std::span(layer.values), panel.width, sight, std::uint8_t{0});
  canvas.blend(panel.x, panel.y, layer, ink::cell_edge, alpha);
  std::fill(layer.values.begin(), layer.values.end(), std::uint8_t{0});
  const double thinner = view.basins.size() > 200 ? 0.6 : 1.0;
  cover(layer, view.basins, std::max(1.2, basin_line_width(em) * thinner));
  clear_outside(std::span(layer.values), panel.width, sight, std::uint8_t{0});
  canvas.blend(panel.x, panel.y, layer, ink::basin_edge, 230);
}

}  // namespace thiessen
