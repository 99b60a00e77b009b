#include "map/sheet/longitude_window.h"

#include <algorithm>
#include <cmath>

namespace thiessen {
namespace {

bool along_pole(Point a, Point b) {
  return a.y == b.y && std::abs(a.y) == 90;
}

/// The step in longitude from a to b, eastward: the short way round, or as written along a pole.
double eastward(Point a, Point b) {
  const double difference = b.x - a.x;
  return along_pole(a, b) || std::abs(difference) <= 180 ? difference
                                                         : std::remainder(difference, 360.0);
}

double from_west(double longitude) {
  const double turned = std::fmod(longitude + 180, 360.0);
  return turned < 0 ? turned + 360 : turned;
}

}  // namespace

double LongitudeWindow::place(double longitude) const {
  const double turned = longitude - 360 * std::floor((longitude - west) / 360);
  return turned >= west + 360 ? turned - 360 : turned;
}

void LongitudeCensus::add(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double step = eastward(a, b);
    if (step >= 0) add_stretch(a.x, a.x + step);
    if (step < 0) add_stretch(a.x + step, a.x);
  }
}

void LongitudeCensus::add(double longitude) {
  add_stretch(longitude, longitude);
}

void LongitudeCensus::add_stretch(double from, double to) {
  const auto slot = [](double turned) {
    const double scaled = turned * (static_cast<double>(slot_count) / 360);
    return std::min(static_cast<std::size_t>(scaled), slot_count - 1);
  };
  const auto see = [&](double longitude) {
    const double turned = from_west(longitude);
    Slot& s = slots_[slot(turned)];
    s.low = std::min(s.low, turned);
    s.high = std::max(s.high, turned);
  };
  see(from);
  see(to);
  const std::size_t first = slot(from_west(from));
  const std::size_t last = slot(from_west(to));
  ++slots_[first].begins;
  if (last + 1 < slot_count) --slots_[last + 1].begins;
  const bool whole_turn = to - from >= 360 && first <= last;
  if (last < first || whole_turn) ++always_;
}

LongitudeWindow LongitudeCensus::window() const {
  double widest = 0;
  double gap_end = 0;
  double previous = -1;  // the last longitude taken up so far
  double first = -1;
  int under_way = always_;
  for (const Slot& s : slots_) {
    const bool entered = under_way > 0;
    under_way += s.begins;
    if (!s.seen()) continue;
    if (first < 0) first = s.low;
    const double gap = s.low - previous;
    if (previous >= 0 && !entered && gap > widest) {
      widest = gap;
      gap_end = s.low;
    }
    previous = s.high;
  }
  if (first < 0) return {};
  const double last_gap = 360 - previous + first;
  if (always_ == 0 && last_gap > widest) {
    widest = last_gap;
    gap_end = first;
  }
  // A gap of two slots or less may be an artefact of rounding longitudes into slots.
  if (widest < 2 * 360.0 / static_cast<double>(slot_count)) return {};
  return {gap_end - 180, 360 - widest};
}

Ring unwrapped(const Ring& ring, const LongitudeWindow& window) {
  Ring result;
  if (ring.empty()) return result;
  result.reserve(ring.size() + 3);
  result.push_back({window.place(ring.front().x), ring.front().y});
  double latitudes = ring.front().y;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    result.push_back({result.back().x + eastward(ring[i - 1], ring[i]), ring[i].y});
    latitudes += ring[i].y;
  }
  const double closing = result.back().x + eastward(ring.back(), ring.front());
  if (std::abs(closing - result.front().x) > 180) {
    const double pole = latitudes >= 0 ? 90 : -90;
    const Point start = result.front();
    result.insert(result.end(), {{closing, start.y}, {closing, pole}, {start.x, pole}});
  }
  return result;
}

}  // namespace thiessen
