#include "outlines/winding_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/number.h"
#include "geometry/ring_location.h"
#include "outlines/ring_direction.h"

namespace thiessen {
namespace {

/// The mean latitude, in degrees, up to which a ring counts as even about the equator; rounding
/// leaves that much of it.
constexpr double no_latitude = 1e-9;

bool knows_its_pole(const WindingRing& ring) {
  return ring.holds_south || ring.holds_north;
}

bool winds(const WindingRing& ring) {
  return ring.winding != 0;
}

std::string begins_and_winds(const WindingRing& ring) {
  return "the ring that begins at " + shortest_text(ring.at(0).x) + " " +
         shortest_text(ring.at(0).y) + " winds round the Earth ";
}

/// The fault that keeps the rings from being a polygon; empty where there is none.
std::string fault_of(const std::vector<WindingRing>& rings) {
  for (const WindingRing& ring : rings) {
    const int times = std::abs(ring.winding);
    if (times > 1) return begins_and_winds(ring) + std::to_string(times) + " times";
  }
  const bool band = winds(rings.front()) && std::any_of(rings.begin() + 1, rings.end(), winds);
  for (const WindingRing& ring : rings) {
    if (band || !winds(ring) || knows_its_pole(ring)) continue;
    if (std::abs(mean_latitude(ring)) < no_latitude)
      return begins_and_winds(ring) + "along the equator: neither pole is nearer";
  }
  return {};
}

void find_pole(WindingRing& ring) {
  if (!winds(ring) || knows_its_pole(ring)) return;
  ring.holds_north = mean_latitude(ring) > 0;
  ring.holds_south = !ring.holds_north;
}

void find_poles(std::vector<WindingRing>& rings) {
  WindingRing& outer = rings.front();
  const bool known = knows_its_pole(outer);
  std::for_each(rings.begin(), rings.end(), find_pole);
  const auto hole = std::find_if(rings.begin() + 1, rings.end(), winds);
  if (known || !winds(outer) || hole == rings.end()) return;
  outer.holds_north = hole->holds_north;
  outer.holds_south = hole->holds_south;
}

/// Leads a ring back along the pole that it holds if it has points there, because it then needs no
/// seam.
void lead_back(WindingRing& ring) {
  if (!winds(ring) || !lead_back_along(ring.holds_north ? 90 : -90, ring)) return;
  ring.holds_north = false;
  ring.holds_south = false;
}

/// Directs an outer ring so that its inside lies to the left, and a hole so that its inside lies to
/// the right.
void direct(WindingRing& ring, bool outer) {
  if (!winds(ring) && ring.holds_south && ring.holds_north) return;
  const bool left =
      ring.winding == 0 ? signed_area(unwrapped(ring)) > 0 : (ring.winding > 0) == ring.holds_north;
  if (left != outer) ring = reversed(ring);
}

bool needs_seam(const std::vector<WindingRing>& rings) {
  const auto holds_a_pole = [](const WindingRing& ring) {
    return winds(ring) || (ring.holds_south && ring.holds_north);
  };
  if (std::any_of(rings.begin(), rings.end(), holds_a_pole) ||
      std::any_of(rings.begin() + 1, rings.end(), runs_along_a_pole))
    return true;
  const Box box = box_of(unwrapped(rings.front()));
  const bool from_antimeridian = std::abs(std::remainder(box.low.x, 360)) == 180;
  return box.width() > 360 || (box.width() == 360 && !from_antimeridian);
}

bool stays_on_one_turn(const WindingRing& ring) {
  return std::all_of(ring.turns.begin(), ring.turns.end(),
                     [&](int turn) { return turn == ring.turns.front(); });
}

void move_by(WindingRing& ring, double turns) {
  for (int& turn : ring.turns) turn += static_cast<int>(turns);
}

double middle_longitude(const WindingRing& ring) {
  const Box box = box_of(unwrapped(ring));
  return (box.low.x + box.high.x) / 2;
}

/// Moves the rings by whole turns so that the outer ring's least longitude lies in [-180, 180) and
/// the holes lie within the outer ring.
void place(std::vector<WindingRing>& rings) {
  const double west = box_of(unwrapped(rings.front())).low.x;
  move_by(rings.front(), -std::floor((west + 180) / 360));
  const double middle = middle_longitude(rings.front());
  for (auto hole = rings.begin() + 1; hole != rings.end(); ++hole)
    move_by(*hole, -std::round((middle_longitude(*hole) - middle) / 360));
}

}  // namespace

std::string add_polygon(std::vector<WindingRing> rings, Longitudes longitudes, CurvedShape& into) {
  std::erase_if(rings, [&](const WindingRing& ring) { return ring.points.empty(); });
  if (rings.empty()) return {};
  std::string fault = fault_of(rings);
  if (!fault.empty()) return fault;
  find_poles(rings);
  std::for_each(rings.begin(), rings.end(), lead_back);
  const bool crosses = !std::all_of(rings.begin(), rings.end(), stays_on_one_turn);
  if (needs_seam(rings) || (longitudes == Longitudes::cut && crosses)) {
    for (WindingRing& ring : rings) direct(ring, &ring == &rings.front());
    append(cut_at_antimeridian(rings), into);
    return {};
  }
  place(rings);
  Polygon& polygon = into.shape.emplace_back();
  for (WindingRing& ring : rings) {
    (&ring == &rings.front() ? polygon.outer : polygon.holes.emplace_back()) = unwrapped(ring);
    if (!ring.bulges.empty()) into.bulges.push_back(std::move(ring.bulges));
  }
  return {};
}

}  // namespace thiessen
