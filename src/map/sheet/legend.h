#pragma once

#include <span>
#include <string>
#include <vector>

#include "map/ink/canvas.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/map_detail.h"
#include "map/sheet/rainfall_classes.h"

namespace thiessen {

struct Page;
struct Picture;
struct PageStyle;

/// The hatch of cells without a reading.
Hatch hatching(int em);

/// The column beside the map: the colour bar with its ticks, and the meaning of the signs.
class Legend {
 public:
  enum class Sign { dry, no_reading, isohyet, gauge, silent_gauge, point, cell, basin, study_area };

  /// The legend of all that is drawn of the maps; heading and unit are those of the first. Where
  /// the unit has no room behind the heading it stands below. Requires at least one map.
  Legend(std::span<const Picture> maps, const MapDetail& detail, const RainfallClasses& classes,
         const PageStyle& style, Typesetter& type);
  Legend(const Picture& picture, const RainfallClasses& classes, const PageStyle& style,
         Typesetter& type);

  int width() const { return width_; }
  int height() const;
  void draw(Canvas& canvas, const Page& page, const RainfallClasses& classes) const;
  /// What of the legend has no room on the page, in words; empty where all has.
  std::string left_out(const Page& page, const RainfallClasses& classes) const;

 private:
  struct Entry {
    Sign sign;
    SetText text;
  };

  void set_heading(const Picture& picture, const PageStyle& style, int most, Typesetter& type);
  int heading_height() const;
  int bar_height(std::size_t classes, int step) const;
  /// The height that the bar takes of a box, with the distance to what stands below it.
  int bar_height(const PixelBox& box, const RainfallClasses& classes) const;
  /// The part of the column in which the bar stands.
  PixelBox bar_box(const PixelBox& column) const;
  /// How many of the signs have room below the bar.
  std::size_t signs_in(const PixelBox& column, int top) const;
  int step_of(const PixelBox& box, const RainfallClasses& classes) const;
  void draw_bar(Canvas& canvas, const PixelBox& box, const RainfallClasses& classes) const;
  void draw_entry(Canvas& canvas, const PixelBox& sign, Sign kind) const;

  int em_;
  int width_ = 0;
  std::string units_;
  std::vector<SetText> heading_;
  std::vector<SetText> ticks_;
  std::vector<Entry> entries_;
};

}  // namespace thiessen
