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
  /// The height in which all of it has room, with lines close to each other.
  int least_height() const;
  void draw(Canvas& canvas, const Page& page, const RainfallClasses& classes) const;
  /// What of the legend has no room on the page, in words; empty where all has.
  std::string left_out(const Page& page) const;

 private:
  struct Entry {
    Sign sign;
    SetText text;
  };
  /// How the parts of the legend share the height of its column: the bar comes before the signs,
  /// for without it no colour means anything.
  struct Layout {
    int top = 0;                   ///< of the bar, with half a line of text over it
    int step = 0;                  ///< the height of a class
    int every = 1;                 ///< one tick in so many has its text
    bool has_small_ticks = false;  ///< because larger ones would not all have room
    int signs_top = 0;
    int line = 0;           ///< the height of a sign's line
    std::size_t signs = 0;  ///< how many have room
  };

  void set_heading(const Picture& picture, const PageStyle& style, int most, Typesetter& type);
  int heading_height() const;
  std::size_t class_count() const { return ticks_.size() < 2 ? ticks_.size() : ticks_.size() - 1; }
  /// The height of a class at which each tick has room for its text.
  int least_step() const;
  /// The height of the bar beside its classes.
  int round_bar() const;
  Layout layout(const PixelBox& column) const;
  void draw_bar(Canvas& canvas, const PixelBox& column, const Layout& places,
                const RainfallClasses& classes) const;
  void draw_entry(Canvas& canvas, const PixelBox& sign, Sign kind) const;

  int em_;
  int width_ = 0;
  std::string units_;
  std::vector<SetText> heading_;
  std::vector<SetText> ticks_;
  std::vector<SetText> small_ticks_;
  int small_step_ = 0;  ///< the height of a class at which each of these has room
  std::vector<Entry> entries_;
};

}  // namespace thiessen
