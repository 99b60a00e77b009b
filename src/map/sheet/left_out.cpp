#include "map/sheet/left_out.h"

#include <algorithm>
#include <utility>

namespace thiessen {

namespace {

/// Some cells that basins cut small are no matter: their neighbours have outlines.
bool is_much(std::size_t some, std::size_t all) {
  return 3 * some > all;
}

}  // namespace

LeftOut::LeftOut(const Page& page, const LabelCount& count, const MapDetail& detail) {
  const auto is_cut = [](const TitleLine& line) { return line.text.is_shortened; };
  if (std::any_of(page.title.begin(), page.title.end(), is_cut) || page.subtitle.is_shortened)
    add("the end of the title");
  if (count.named < count.to_name) {
    add("the names of " + std::to_string(count.to_name - count.named) + " of " +
        std::to_string(count.to_name) + " basins");
  }
  if (count.levelled < count.isohyets) {
    add("the levels of " + std::to_string(count.isohyets - count.levelled) + " of " +
        std::to_string(count.isohyets) + " isohyets");
  }
  if (!detail.has_cell_outlines) {
    add("the outlines of cells");
  } else if (count.outlined > 0 && is_much(count.cells - count.outlined, count.cells)) {
    add("the outlines of " + std::to_string(count.cells - count.outlined) + " of " +
        std::to_string(count.cells) + " cells");
  }
  if (!detail.has_basin_outlines) add("the outlines of basins");
}

void LeftOut::add(std::string thing) {
  if (!thing.empty()) things_.push_back(std::move(thing));
}

void LeftOut::add_note(const std::string& note) {
  add("the note \"" + note + "\"");
}

void LeftOut::tell(Warnings& warnings) const {
  if (things_.empty()) return;
  std::string list;
  for (std::size_t i = 0; i < things_.size(); ++i)
    list += (i == 0 ? "" : i + 1 == things_.size() ? " and " : ", ") + things_[i];
  warnings.add_notice(
      {{}, 0, "the picture has no room for " + list, "a larger " + setting("size") + " has more"});
}

}  // namespace thiessen
