#include "outlines/basin_mending.h"

#include <utility>
#include <vector>

#include "base/counted.h"
#include "base/number.h"
#include "outlines/area_words.h"
#include "outlines/disputed_ground.h"
#include "outlines/polygon_validity.h"
#include "outlines/ring_direction.h"

namespace thiessen {
namespace {

// These are shares of the basin's area: the most that rounding may leave in dispute, and the most
// that a mending may.
constexpr double same_area = 1e-9;
constexpr double nearly_same_area = 1e-5;

/// The counts of what was mended in a basin.
struct Mended {
  std::size_t repeated = 0;
  std::size_t spikes = 0;
  std::size_t open = 0;
  std::size_t parts = 0;
  std::size_t holes = 0;
  std::string redrawn;  ///< why the rings were drawn anew; empty where they were not

  bool any() const { return repeated + spikes + open + parts + holes > 0 || !redrawn.empty(); }
};

std::string sentence(const Mended& mended) {
  std::vector<std::string> what;
  if (mended.repeated > 0) what.push_back(counted(mended.repeated, "repeated point"));
  if (mended.spikes > 0) what.push_back(counted(mended.spikes, "spike"));
  if (mended.open > 0) what.push_back(counted(mended.open, "open ring"));
  if (mended.parts > 0)
    what.push_back(counted(mended.parts, "part without area", "parts without area"));
  if (mended.holes > 0)
    what.push_back(counted(mended.holes, "hole without area", "holes without area"));
  if (!mended.redrawn.empty()) what.push_back(mended.redrawn);
  std::string text;
  for (std::size_t i = 0; i < what.size(); ++i) text += (i == 0 ? "" : ", ") + what[i];
  return text;
}

/// Adds a point to a ring so that the ring never doubles back: a repeated point is left out, and a
/// spike is removed with the point that returns from it.
void append(Ring& ring, Point point, Mended& mended) {
  if (!ring.empty() && ring.back() == point) {
    ++mended.repeated;
  } else if (ring.size() > 1 && ring[ring.size() - 2] == point) {
    ring.pop_back();
    ++mended.spikes;
  } else {
    ring.push_back(point);
  }
}

/// Removes repeated points and spikes where the ring's last points meet its first ones.
void trim_seam(Ring& ring, Mended& mended) {
  std::size_t first = 0;
  while (ring.size() - first > 2) {
    if (ring.back() == ring[first]) {
      ring.pop_back();
      ++mended.repeated;
    } else if (ring[ring.size() - 2] == ring[first]) {
      ring.resize(ring.size() - 2);
      ++mended.spikes;
    } else if (ring.back() == ring[first + 1]) {
      ++first;
      ring.pop_back();
      ++mended.spikes;
    } else {
      break;
    }
  }
  ring.erase(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first));
}

Ring cleaned(const Ring& raw, Mended& mended) {
  Ring ring;
  ring.reserve(raw.size());
  std::size_t length = raw.size();
  if (length > 1 && raw.front() == raw.back()) {
    --length;
  } else {
    ++mended.open;
  }
  for (std::size_t i = 0; i < length; ++i) append(ring, raw[i], mended);
  trim_seam(ring, mended);
  return ring;
}

MultiPolygon cleaned(const MultiPolygon& raw, Mended& mended) {
  MultiPolygon shape;
  for (const Polygon& part : raw) {
    Polygon polygon;
    polygon.outer = cleaned(part.outer, mended);
    for (const Ring& hole : part.holes) {
      Ring ring = cleaned(hole, mended);
      if (ring.size() > 2) {
        polygon.holes.push_back(std::move(ring));
      } else {
        ++mended.holes;
      }
    }
    // A part whose shell has no area goes, with the holes that it cannot have.
    if (polygon.outer.size() > 2) {
      shape.push_back(std::move(polygon));
    } else {
      ++mended.parts;
    }
  }
  return shape;
}

/// The place and the amount of what is in dispute: ` at 5 5: 25 % of its area (10 km2)`.
std::string dispute(const Ground& ground, const MendingRules& rules) {
  MultiPolygon disputed = ground.disputed;
  turn_rings(disputed);
  const Point at = ground.place.value_or(Point{});
  return rounded_text(100 * ground.disputed_area / ground.area) + " % of its area (" +
         area_words(disputed, rules.kind, rules.round_the_earth) + ") is in dispute at " +
         shortest_text(at.x) + " " + shortest_text(at.y);
}

/// Draws a shape's rings anew where that is allowed. Returns an empty text, or why it is not done.
std::string redraw(MultiPolygon& shape, const std::string& fault, const MendingRules& rules,
                   Mended& mended) {
  Ground ground = ground_of(shape);
  if (!(ground.area > 0)) return "has no area: " + fault;
  if (ground.disputed_area <= same_area * ground.area) {
    mended.redrawn = "where it meets itself (" + fault + ")";
  } else if (rules.by_union || ground.disputed_area <= nearly_same_area * ground.area) {
    mended.redrawn =
        "where it crosses itself: each piece of ground counts once, " + dispute(ground, rules);
  } else {
    return "crosses or overlaps itself: " + dispute(ground, rules);
  }
  shape = std::move(ground.shape);
  const std::string left = validity_fault(shape);
  return left.empty() ? "" : "cannot be mended: " + left;
}

}  // namespace

std::optional<MultiPolygon> mend(const RawBasin& basin, const MendingRules& rules,
                                 const std::string& file, Warnings& warnings,
                                 Complaints& complaints) {
  const auto refuse = [&](const std::string& text, const Wording& hint) {
    complaints.add({file, basin.line, basin.place + " " + text, hint});
    return std::nullopt;
  };
  const Wording draw = "a basin is a ring of three or more points that are not on one line";
  const Wording unite = setting("mend") + " counts each piece of its ground once";
  Mended mended;
  MultiPolygon shape = cleaned(basin.polygons, mended);
  if (shape.empty()) return refuse("has no area", draw);
  const std::string fault = validity_fault(shape);
  if (!fault.empty()) {
    const std::string reason = redraw(shape, fault, rules, mended);
    if (!reason.empty()) return refuse(reason, reason.starts_with("has no area") ? draw : unite);
  }
  turn_rings(shape);
  if (mended.any())
    warnings.add({file, basin.line, basin.place + " is mended: " + sentence(mended), {}});
  return shape;
}

}  // namespace thiessen
