#include "earth/cells/longitude_turn.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "earth/sphere/units.h"

namespace thiessen {
namespace {

constexpr double micrometre = 1e-6;

/// Draws chords at the seam once more on the other side, with a node for each that they share.
class OtherSide {
 public:
  OtherSide(Diagram& diagram, double west) : diagram_(diagram), west_(west) {}

  void draw() {
    const std::vector<Chord> chords = std::exchange(diagram_.chords, {});
    const std::vector<double> bulges = std::exchange(diagram_.bulges, {});
    for (std::size_t i = 0; i < chords.size(); ++i) {
      throw_if_interrupted();
      bulge_ = bulges.empty() ? nullptr : &bulges[i];
      draw(chords[i]);
    }
  }

 private:
  void draw(const Chord& chord) {
    const double from = diagram_.nodes[chord.from].x;
    const double to = diagram_.nodes[chord.to].x;
    const double step = to - from;
    if (std::abs(step) > 180) {
      const int turn = step > 0 ? -1 : 1;
      add({chord.from, turned(chord.to, turn), chord.left, chord.right});
      add({turned(chord.from, -turn), chord.to, chord.left, chord.right});
      return;
    }
    add(chord);
    if (from == west_ || to == west_)
      add({turned(chord.from, 1), turned(chord.to, 1), chord.left, chord.right});
  }

  void add(const Chord& chord) {
    diagram_.chords.push_back(chord);
    if (bulge_ != nullptr) diagram_.bulges.push_back(*bulge_);
  }

  std::uint32_t turned(std::uint32_t node, int turn) {
    const auto next = static_cast<std::uint32_t>(diagram_.nodes.size());
    const auto [entry, is_new] = turned_.emplace(std::pair(node, turn), next);
    if (is_new) {
      const Point p = diagram_.nodes[node];
      diagram_.nodes.push_back({p.x + 360 * turn, p.y});
    }
    return entry->second;
  }

  Diagram& diagram_;
  double west_;
  const double* bulge_ = nullptr;  // of the chord at hand
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> turned_;
};

}  // namespace

LongitudeTurn::LongitudeTurn(const Box& frame)
    : west_(frame.centre().x - 180), antimeridian_(180 + 360 * std::ceil((west_ - 180) / 360)) {}

bool LongitudeTurn::is_clear_of_cuts(double x) const {
  constexpr double degrees = 1;
  return x - west_ > degrees && west_ + 360 - x > degrees && std::abs(x - antimeridian_) > degrees;
}

Point LongitudeTurn::within(Point p) const {
  p.x -= 360 * std::floor((p.x - west_) / 360);
  // A micrometre is less than a degree of longitude up to here.
  constexpr double far_from_pole = 89.9;
  if (std::abs(p.y) <= far_from_pole && is_clear_of_cuts(p.x)) return p;
  if (std::abs(p.y) < 90) {
    const double near = micrometre / (mean_radius * degree * std::cos(p.y * degree));
    const double antimeridian = 180 + 360 * std::round((p.x - 180) / 360);
    for (const double cut : {antimeridian, west_, west_ + 360})
      if (std::abs(p.x - cut) <= near) p.x = cut;
  }
  // Rounding may have left the turn.
  if (p.x < west_) p.x += 360;
  if (p.x >= west_ + 360) p.x -= 360;
  return p;
}

void LongitudeTurn::draw_on_both_sides(Diagram& diagram) const {
  const bool any = std::any_of(diagram.chords.begin(), diagram.chords.end(), [&](const Chord& c) {
    const double from = diagram.nodes[c.from].x;
    const double to = diagram.nodes[c.to].x;
    return from == west_ || to == west_ || std::abs(to - from) > 180;
  });
  if (any) OtherSide(diagram, west_).draw();
}

}  // namespace thiessen
