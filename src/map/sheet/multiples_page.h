#pragma once

#include <cstddef>
#include <vector>

#include "map/opencv/typesetter.h"
#include "map/sheet/legend.h"
#include "map/sheet/map_grid.h"
#include "map/sheet/page.h"
#include "map/sheet/picture.h"

namespace thiessen {

/// The places of several maps on a page, and of what they share.
struct MultiplesPage {
  Page page;  ///< its panel holds all maps with their headings
  MapGrid grid;
  std::vector<PixelBox> maps;
  PageStyle style;  ///< of what is drawn in a map and beside it, smaller than the page's
};

/// Lays the page out for so many maps of a study area of the given extent, in the grid that makes
/// them largest. A height of 0 is chosen so that maps fit the extent; the grid is then that of a
/// page three quarters as high as wide. Throws Error where the maps would be too small to be read,
/// which names the size.
MultiplesPage lay_out_multiples(const Picture& picture, std::size_t maps, const Extent& extent,
                                const Legend& legend, Typesetter& type);

}  // namespace thiessen
