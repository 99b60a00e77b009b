#pragma once

#include <span>
#include <string>
#include <vector>

#include "map/ink/canvas.h"
#include "map/opencv/typesetter.h"
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

  /// The legend of all that the maps show, whose gauges may not be drawn; heading and unit are
  /// those of the first. Requires at least one map.
  Legend(std::span<const Picture> maps, bool has_gauges, const RainfallClasses& classes,
         const PageStyle& style, Typesetter& type);
  Legend(const Picture& picture, const RainfallClasses& classes, const PageStyle& style,
         Typesetter& type);

  int width() const { return width_; }
  int height() const;
  void draw(Canvas& canvas, const Page& page, const RainfallClasses& classes) const;

 private:
  struct Entry {
    Sign sign;
    SetText text;
  };

  int bar_height(std::size_t classes, int step) const;
  int draw_bar(Canvas& canvas, const PixelBox& box, const RainfallClasses& classes) const;
  void draw_entry(Canvas& canvas, const PixelBox& sign, Sign kind) const;

  int em_;
  int width_ = 0;
  std::string units_;
  SetText heading_;
  std::vector<SetText> ticks_;
  std::vector<Entry> entries_;
};

}  // namespace thiessen
