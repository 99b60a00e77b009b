#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "map/sheet/annotation.h"
#include "map/sheet/map_detail.h"
#include "map/sheet/page.h"

namespace thiessen {

/// Gathers what a page has no room for and does not say itself.
class LeftOut {
 public:
  /// The end of the title, names of basins, levels of isohyets, outlines.
  LeftOut(const Page& page, const LabelCount& count, const MapDetail& detail);

  /// Adds a thing in words; none where they are empty.
  void add(std::string thing);
  /// Adds a note that should stand below the map.
  void add_note(const std::string& note);
  /// Tells all in one notice; nothing where all has room.
  void tell(Warnings& warnings) const;

 private:
  std::vector<std::string> things_;
};

}  // namespace thiessen
