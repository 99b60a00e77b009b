#include "basin/nearest_ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/segment.h"

namespace thiessen {

NearestGround::Line& NearestGround::Lines::add() {
  if (count == lines.size()) lines.emplace_back();
  Line& line = lines[count++];
  line.clear();
  return line;
}

void NearestGround::take_ground(const Basin& ground, Point origin) {
  ground_.count = 0;
  std::size_t ring_number = 0;
  const auto add = [&](const Ring& ring) {
    add_ring(ring, ground.bulges.empty() ? nullptr : &ground.bulges[ring_number], origin);
    ++ring_number;
  };
  for (const Polygon& part : ground.shape) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
}

void NearestGround::add_ring(const Ring& ring, const std::vector<double>* bulges, Point origin) {
  Line& line = ground_.add();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    line.push_back({{ring[i].x - origin.x, ring[i].y - origin.y},
                    bulges == nullptr ? 0 : (*bulges)[i],
                    0,
                    1,
                    of_ground,
                    of_ground});
  }
}

// What bends the border decides only where a corner is that near to it.
NearestGround::Side NearestGround::side_of(const Lines& lines, std::size_t a, std::size_t b) const {
  const Nearness& first = places_[a];
  const Nearness& second = places_[b];
  const double by_1 = first.straight[0] - second.straight[0];
  const double by_x = first.straight[1] - second.straight[1];
  const double by_y = first.straight[2] - second.straight[2];
  const double most_bent = first.most_bent + second.most_bent;
  bool is_nearer = false;
  bool is_farther = false;
  for (const Line& line : lines.all()) {
    for (const Corner& corner : line) {
      double value = by_1 + by_x * corner.at.x + by_y * corner.at.y;
      if (std::abs(value) <= most_bent)
        value += first.bent_at(corner.at) - second.bent_at(corner.at);
      (value > 0 ? is_farther : is_nearer) = true;
    }
    if (is_nearer && is_farther) return Side::both;
  }
  return is_farther ? Side::farther : Side::nearer;
}

// Leaves of the lines what is nearer to the one place than to the other; returns whether that is
// anything.
bool NearestGround::cut(Lines& lines, std::uint32_t nearer, std::uint32_t farther) {
  switch (side_of(lines, nearer, farther)) {
    case Side::nearer:
      return true;
    case Side::farther:
      lines.count = 0;
      return false;
    case Side::both:
      break;
  }
  const Nearness border = places_[nearer] - places_[farther];
  std::size_t kept = 0;
  for (std::size_t i = 0; i < lines.count; ++i) {
    cut(lines.lines[i], border, {{}, 0, 0, 1, nearer, farther}, spare_);
    if (spare_.size() < 3) continue;
    std::swap(lines.lines[kept++], spare_);
  }
  lines.count = kept;
  return kept > 0;
}

void NearestGround::cut(const Line& line, const Nearness& border, const Corner& along, Line& left) {
  left.clear();
  values_.resize(line.size());
  for (std::size_t i = 0; i < line.size(); ++i) values_[i] = border.at(line[i].at);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t next = i + 1 < line.size() ? i + 1 : 0;
    const bool is_left = values_[i] <= 0;
    if (is_left) left.push_back(line[i]);
    if (is_left == (values_[next] <= 0)) continue;
    add_crossing(line[i], line[next].at, border, {values_[i], values_[next]}, along, left);
  }
}

// Adds the point at which an edge crosses the border, whose values are known at its ends. Where
// nearer ground ends there the edge behind it runs along the border, else it is what is left of
// this one.
void NearestGround::add_crossing(const Corner& from, Point to, const Nearness& border,
                                 std::pair<double, double> values, const Corner& along,
                                 Line& left) const {
  const double growth = values.second - values.first;
  double share = -values.first / growth;
  Point at = between(from.at, to, share);
  if (border.most_bent > 0) {
    constexpr int steps = 2;  // each leaves a thousandth of the way
    for (int step = 0; step < steps; ++step) {
      share = std::clamp(share - border.at(at) / growth, 0.0, 1.0);
      at = between(from.at, to, share);
    }
    if (from.nearer != of_ground)
      at = moved_onto_both(at, border, places_[from.nearer] - places_[from.farther]);
  }
  const double along_whole = from.begin + share * (from.end - from.begin);
  Corner corner = values.first <= 0 ? along : from;
  corner.at = at;
  if (values.first <= 0) {
    left.back().end = along_whole;
  } else {
    corner.begin = along_whole;
  }
  left.push_back(corner);
}

// A border bends so little that each step leaves a hundredth of the way. Where two hardly cross,
// the point stays where it is.
Point NearestGround::moved_onto_both(Point near, const Nearness& one, const Nearness& other) const {
  const double determinant =
      one.straight[1] * other.straight[2] - one.straight[2] * other.straight[1];
  const double sizes = std::hypot(one.straight[1], one.straight[2]) *
                       std::hypot(other.straight[1], other.straight[2]);
  constexpr double least_sine = 1e-3;
  if (std::abs(determinant) <= least_sine * sizes) return near;
  constexpr int steps = 3;
  for (int step = 0; step < steps; ++step) {
    const double off_one = one.at(near);
    const double off_other = other.at(near);
    near.x -= (off_one * other.straight[2] - off_other * one.straight[2]) / determinant;
    near.y -= (off_other * one.straight[1] - off_one * other.straight[1]) / determinant;
  }
  return near;
}

// A place is next somewhere only if it is nearer than any other at a corner, because nearness is
// straight, or bends by no more than is allowed for.
void NearestGround::find_next(std::size_t members) {
  next_.clear();
  const auto count = static_cast<std::uint32_t>(places_.size());
  const Point start = left_.lines.front().front().at;
  auto best = static_cast<std::uint32_t>(members);
  for (std::uint32_t p = best + 1; p < count; ++p) {
    if (places_[p].at(start) < places_[best].at(start)) best = p;
  }
  for (auto p = static_cast<std::uint32_t>(members); p < count; ++p) {
    if (p == best || side_of(left_, p, best) != Side::farther) next_.push_back(p);
  }
}

std::span<const double> NearestGround::areas_by_next(std::size_t members, std::size_t own) {
  areas_.assign(places_.size() - members, 0);
  left_.count = 0;
  for (const Line& line : ground_.all()) {
    Line& copy = left_.add();
    copy.assign(line.begin(), line.end());
  }
  if (areas_.empty() || left_.count == 0) return areas_;
  for (std::uint32_t member = 0; member < members; ++member) {
    if (member == own) continue;
    for (auto p = static_cast<std::uint32_t>(members); p < places_.size(); ++p) {
      if (!cut(left_, member, p)) return areas_;
    }
  }
  find_next(members);
  for (const std::uint32_t next : next_) {
    part_.count = 0;
    for (const Line& line : left_.all()) {
      Line& copy = part_.add();
      copy.assign(line.begin(), line.end());
    }
    bool is_any = true;
    for (std::size_t i = 0; is_any && i < next_.size(); ++i)
      is_any = next_[i] == next || cut(part_, next, next_[i]);
    if (is_any) areas_[next - members] = area_of(part_);
  }
  return areas_;
}

double NearestGround::area_of(const Lines& lines) const {
  double area = 0;
  for (const Line& line : lines.all()) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Corner& from = line[i];
      const Point to = line[i + 1 < line.size() ? i + 1 : 0].at;
      if (chart_ == nullptr) {
        area += (from.at.x * to.y - to.x * from.at.y) / 2 * unit_area_;
        continue;
      }
      area += bulge_of(from, to) - ChartSurface(*chart_).under(from.at, to, 0);
    }
  }
  return area;
}

// The area between the true edge and its chord, positive to the right, as that of a parabola.
double NearestGround::bulge_of(const Corner& from, Point to) const {
  if (from.nearer == of_ground)
    return from.bulge * (bulge_share(from.end) - bulge_share(from.begin));
  const Nearness border = places_[from.nearer] - places_[from.farther];
  const Point middle = between(from.at, to, 0.5);
  const Point way{to.x - from.at.x, to.y - from.at.y};
  // The growth to the right, times the chord's length.
  const double growth = border.straight[1] * way.y - border.straight[2] * way.x;
  if (growth == 0) return 0;
  const double square = way.x * way.x + way.y * way.y;
  return 2. / 3 * square * (-border.at(middle) / growth) * chart_->unit_area(middle);
}

}  // namespace thiessen
