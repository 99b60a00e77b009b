#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "map/ink/canvas.h"
#include "map/ink/labels.h"
#include "map/opencv/label_image.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/page.h"
#include "map/sheet/picture.h"
#include "map/sheet/study_view.h"

namespace thiessen {

/// How many gauges, names and lines a map, or several, have, and how many of these find room.
struct LabelCount {
  std::size_t gauges = 0;
  std::size_t in_sight = 0;
  std::size_t to_label = 0;  ///< of those in sight, which have a label
  std::size_t labelled = 0;
  std::size_t to_name = 0;  ///< basins that have a name
  std::size_t named = 0;
  std::size_t isohyets = 0;  ///< that have a line
  std::size_t levelled = 0;  ///< of these, whose level is written somewhere
  std::size_t cells = 0;
  std::size_t outlined = 0;  ///< of these, which are large enough for a line round them

  LabelCount& operator+=(const LabelCount& other);
};

/// Words how many gauges are in sight and how many of these are labelled; empty where all are.
std::string note_of(const LabelCount& count);

/// Draws gauges, basin names and gauge labels into the panel. Only dots may overlap each other:
/// names and labels overlap nothing, and no label stands beside the dot of another gauge.
class Annotation {
 public:
  /// `view` is in pixels of the panel.
  Annotation(Canvas& canvas, const Page& page, const Picture& picture, const StudyView& view,
             Typesetter& type);

  /// Draws the gauges, silent ones first, so that none of them hides one that reports.
  void draw_gauges();
  /// Writes the level of isohyets over their longest lines, where these are straight and level and
  /// nothing else stands: the first time in any case that there is room, then at some distance.
  void draw_levels();
  /// Writes the name of each basin in its middle, or as near to that as it fits inside the basin.
  void draw_basin_names(const LabelImage& basins);
  /// Labels the gauges in sight, those of the largest cells (`pixels`) first, equal ones in their
  /// order.
  void draw_labels(const std::vector<std::size_t>& pixels);

  /// What has been drawn so far.
  const LabelCount& count() const { return count_; }

 private:
  bool in_sight(Point p) const;
  int halo_width() const;
  std::vector<Point> dots_in_sight() const;
  void draw_level(std::size_t isohyet, int size);
  void put(const SetText& text, const PixelBox& box, Colour colour, const Mark& mark);

  Canvas& canvas_;
  const Page& page_;
  const Picture& picture_;
  const StudyView& view_;
  Typesetter& type_;
  Occupancy taken_;
  LabelCount count_;
  double radius_ = 1;
};

}  // namespace thiessen
