#include "map/sheet/multiples_page.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace thiessen {
namespace {

/// The shortest side of a map on which a study area is more than a speck, in pixels.
constexpr int smallest_map = 60;

[[noreturn]] void refuse(const Picture& picture, std::size_t maps) {
  const std::string height = picture.height > 0 ? " x " + std::to_string(picture.height) : "";
  throw Error(Message{{},
                      0,
                      std::to_string(maps) + " maps have no room on a page of " +
                          std::to_string(picture.width) + height + " pixels",
                      "choose a larger " + setting("size") + ", or fewer of " + setting("time")});
}

/// The style of a map of so many pixels on a page of this style.
PageStyle map_style(const MapGrid& grid, const PageStyle& page) {
  constexpr int smallest_em = 11;
  constexpr double ems_across = 40;
  PageStyle style = page;
  const double side = std::sqrt(static_cast<double>(grid.width) * grid.height);
  style.em = std::clamp(static_cast<int>(std::lround(side / ems_across)), smallest_em, page.em);
  style.hairline = std::max(1, style.ems(0.06));
  return style;
}

/// The height of a map where the page has none of its own: as the extent has it, but as high as the
/// legend needs, and no higher than a picture may be.
int open_height(const Picture& picture, const MapGrid& grid, const Legend& legend,
                const GridRoom& room, const GridGaps& gaps) {
  const double most =
      std::min<double>(max_picture_side, static_cast<double>(max_picture_pixels) / picture.width) -
      room.below;
  const int least = legend.height() / grid.rows - gaps.above;
  return std::min(std::max(grid.height, least), static_cast<int>(most / grid.rows) - gaps.above);
}

}  // namespace

MultiplesPage lay_out_multiples(const Picture& picture, std::size_t maps, const Extent& extent,
                                const Legend& legend, Typesetter& type) {
  MultiplesPage sheet;
  Page& page = sheet.page;
  page.style = page_style(picture.width, picture.height, picture.dots_to_the_inch);
  if (page.style.bare) refuse(picture, maps);
  page.width = picture.width;
  const int em = page.style.em;
  const int column = legend.width() == 0 ? 0 : legend.width() + em;
  const int top = set_head(picture.title, "", page, type);
  const int left = page.style.ems(2.6);
  const int below = page.style.ems(4.4);
  const GridGaps gaps{page.style.ems(0.8), page.style.ems(1.6)};
  GridRoom room{page.width - left - em - column, 0, left + em + column, top + below};
  if (picture.height > 0) room.height = std::max(1, picture.height - room.below);
  sheet.grid = best_grid(maps, panel_aspect(extent), room, gaps);
  MapGrid& grid = sheet.grid;
  if (picture.height == 0) grid.height = open_height(picture, grid, legend, room, gaps);
  if (std::min(grid.width, grid.height) < smallest_map) refuse(picture, maps);
  sheet.maps = places_in(grid, maps, left, top, gaps);
  sheet.style = map_style(grid, page.style);
  const int inside = grid.rows * (grid.height + gaps.above);
  page.height = picture.height > 0 ? picture.height : inside + room.below;
  page.panel = {left, top, room.width, inside};
  page.legend = {left + room.width + em, top + gaps.above, legend.width(),
                 page.height - room.below - gaps.above};
  const int foot = page.style.ems(3.4);
  page.footer = {left, page.height - foot, room.width + column, foot};
  return sheet;
}

}  // namespace thiessen
