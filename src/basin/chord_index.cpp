#include "basin/chord_index.h"

namespace thiessen {
namespace {

constexpr std::size_t few_chords = 40;

bool have_common_end(const Chord& a, const Chord& b) {
  return a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
}

/// The positions at which runs of chords begin, and the number of chords at the end. In a run each
/// chord ends where the one before does, at either end. A tree of runs is a quarter of the size of
/// a tree of chords where edges have many, and half of it in a plane, where there is one chord an
/// edge.
std::vector<std::uint32_t> runs_of(const Diagram& diagram) {
  constexpr std::uint32_t longest = 4;
  std::vector<std::uint32_t> first;
  const auto count = static_cast<std::uint32_t>(diagram.chords.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool goes_on = i > 0 && have_common_end(diagram.chords[i - 1], diagram.chords[i]);
    if (!goes_on || i - first.back() == longest) first.push_back(i);
  }
  first.push_back(count);
  return first;
}

std::vector<Box> boxes_of(const Diagram& diagram, const std::vector<std::uint32_t>& first_of_run) {
  std::vector<Box> boxes(first_of_run.size() - 1);
  for (std::size_t run = 0; run < boxes.size(); ++run) {
    for (std::uint32_t i = first_of_run[run]; i < first_of_run[run + 1]; ++i) {
      boxes[run].take_in(box_of(diagram, diagram.chords[i]));
    }
  }
  return boxes;
}

}  // namespace

ChordIndex::ChordIndex(const Diagram& diagram, Searches searches)
    : diagram_(diagram),
      searches_(searches),
      first_of_run_(searches == Searches::few || diagram.chords.size() <= few_chords
                        ? std::vector<std::uint32_t>{0}
                        : runs_of(diagram)),
      tree_(boxes_of(diagram, first_of_run_)) {
  if (searches == Searches::few || diagram.chords.size() > few_chords) return;
  for (const Chord& chord : diagram.chords) boxes_.push_back(box_of(diagram, chord));
}

}  // namespace thiessen
