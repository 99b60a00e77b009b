#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "map/ink/canvas.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/legend.h"
#include "map/sheet/map_shape.h"
#include "map/sheet/picture.h"

namespace thiessen {

/// The lengths that all parts of a picture share; they follow from the picture's size.
struct PageStyle {
  int em = 16;        ///< the ordinary text size, in pixels
  int hairline = 1;   ///< width of borders and ticks, in pixels
  bool bare = false;  ///< too small for any text: the map alone
  /// The least size of type in pixels: five points where the picture's density is known.
  int least_type = 8;

  int ems(double count) const { return static_cast<int>(std::lround(em * count)); }
};

/// A line of the title, and the row of the page on which its letters stand.
struct TitleLine {
  SetText text;
  int baseline = 0;
};

/// The places of everything on the page. No two boxes overlap.
struct Page {
  int width = 0;
  int height = 0;
  PageStyle style;
  PixelBox panel;  ///< the map; coordinates stand to the left of it and below it
  std::vector<TitleLine> title;
  SetText subtitle;
  int subtitle_baseline = 0;
  PixelBox legend;  ///< the column to the right of the map; no width where there is none
  /// The place of scale bar, north arrow and notes below the map; no height where there is none.
  PixelBox footer;
};

/// How large a title is: `small` leaves more of a low page to what stands below it.
enum class Head { large, small };

/// Sets the title, and the subtitle unless it is empty, at the upper end of the page, which
/// has its width and style already. Returns the height that they take.
int set_head(const std::string& title, const std::string& subtitle, Page& page, Typesetter& type,
             Head head = Head::large);

/// The width of a map that suits the extent, divided by its height.
double panel_aspect(const Extent& extent);

/// Lays the page out for a study area of the given extent. The title is small where the legend has
/// no room beside the map else. A height of 0 is chosen so that the map
/// fits the extent, unless the extent is too long or too tall for a page.
Page lay_out(const Picture& picture, const Extent& extent, const Legend& legend, Typesetter& type);

/// The style of a picture of this size; a height of 0 counts as three quarters of the width.
/// Letters grow with the picture, but where its density is known (else 0) not beyond ten points, so
/// that a larger page holds more of them.
PageStyle page_style(int width, int height, int dots_to_the_inch = 0);

/// Maps the map's plane to pixels of the panel, with the extent in the panel's middle.
class PanelTransform {
 public:
  PanelTransform(const Extent& extent, const PixelBox& panel);

  Point operator()(Point map) const {
    return {(map.x - middle_.x) * scale_ + centre_.x, (middle_.y - map.y) * scale_ + centre_.y};
  }
  /// The place on the map's plane of a pixel of the panel.
  Point inverse(Point pixel) const {
    return {(pixel.x - centre_.x) / scale_ + middle_.x, middle_.y - (pixel.y - centre_.y) / scale_};
  }
  /// The number of pixels to a map unit.
  double scale() const { return scale_; }

 private:
  Point middle_;
  Point centre_;
  double scale_ = 1;
};

}  // namespace thiessen
