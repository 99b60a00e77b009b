#pragma once

#include <string>
#include <vector>

#include "map/ink/canvas.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/ticks.h"

namespace thiessen {

struct Page;
struct Picture;
struct PageStyle;

/// The classes into which rainfall is sorted, between round values, each of one colour.
class RainfallClasses {
 public:
  /// Lays classes from the least to the largest reading of the cells; there are none where no cell
  /// has a reading.
  explicit RainfallClasses(const Picture& picture);

  /// The round values between the classes; a single one where all readings are equal.
  const std::vector<RoundValue>& ticks() const { return ticks_; }
  std::size_t count() const { return ticks_.size() < 2 ? ticks_.size() : ticks_.size() - 1; }
  /// The colour of a reading's class. Requires a reading between the least and the largest.
  Colour colour(double rainfall) const;

 private:
  std::vector<RoundValue> ticks_;
  std::vector<double> values_;
};

/// The hatch of cells without a reading.
Hatch hatching(int em);

/// The column beside the map: the colour bar with its ticks, and the meaning of the signs.
class Legend {
 public:
  enum class Sign { gauge, silent_gauge, no_reading, cell, basin };

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
