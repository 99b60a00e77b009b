#include "outlines/vertex_rounding.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "base/number.h"
#include "outlines/polygon_validity.h"
#include "outlines/ring_direction.h"
#include "outlines/star_shape.h"

namespace thiessen {
namespace {

// The decimals that a vertex of each level has beyond those of most vertices. One more is a
// hundredth of the tolerance; the level after the last one has all digits.
constexpr std::array<int, 4> more_decimals = {0, 1, 4, 7};
constexpr int all_digits = static_cast<int>(more_decimals.size());

bool keeps_its_side(const Ring& ring, bool outer) {
  return ring.size() > 2 && (signed_area(ring) > 0) == outer;
}

}  // namespace

bool is_writable(const MultiPolygon& shape) {
  for (const Polygon& polygon : shape) {
    if (!keeps_its_side(polygon.outer, true)) return false;
    for (const Ring& hole : polygon.holes) {
      if (!keeps_its_side(hole, false)) return false;
    }
  }
  const bool is_one_ring = shape.size() == 1 && shape.front().holes.empty();
  if (is_one_ring && is_star_shaped(shape.front().outer)) return true;
  return validity_fault(shape).empty();
}

std::size_t VertexRounding::Hash::operator()(Point point) const {
  const std::size_t x = std::hash<double>()(point.x);
  const std::size_t y = std::hash<double>()(point.y);
  return x ^ (y * 0x9e3779b97f4a7c15U + (x << 6U) + (x >> 2U));
}

VertexRounding::VertexRounding(std::span<const MultiPolygon> cells, int decimals)
    : decimals_(decimals) {
  std::vector<bool> checked(cells.size(), false);
  for (int level = 0;; ++level) {
    std::vector<std::size_t> bad;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (checked[i]) continue;
      checked[i] = true;
      MultiPolygon written = cells[i];
      for (Polygon& polygon : written) {
        polygon.outer = rounded(polygon.outer);
        for (Ring& hole : polygon.holes) hole = rounded(hole);
      }
      if (!is_writable(written)) bad.push_back(i);
    }
    if (level == 1) narrow_ = bad;
    if (level == all_digits) faulty_ = bad;
    if (bad.empty() || level == all_digits) return;
    for (const std::size_t i : bad) refine(cells[i], level + 1);
    for (std::size_t i = 0; i < cells.size(); ++i) checked[i] = !holds(cells[i]);
  }
}

void VertexRounding::refine(const MultiPolygon& cell, int level) {
  const auto ring = [&](const Ring& points) {
    for (const Point point : points) levels_[point] = level;
  };
  for (const Polygon& polygon : cell) {
    ring(polygon.outer);
    for (const Ring& hole : polygon.holes) ring(hole);
  }
}

/// Whether a vertex of the cell is written with more decimals than most.
bool VertexRounding::holds(const MultiPolygon& cell) const {
  const auto ring = [&](const Ring& points) {
    return std::any_of(points.begin(), points.end(),
                       [&](Point point) { return levels_.contains(point); });
  };
  return std::any_of(cell.begin(), cell.end(), [&](const Polygon& polygon) {
    return ring(polygon.outer) || std::any_of(polygon.holes.begin(), polygon.holes.end(), ring);
  });
}

int VertexRounding::level_of(Point point) const {
  if (levels_.empty()) return 0;
  const auto found = levels_.find(point);
  return found == levels_.end() ? 0 : found->second;
}

void VertexRounding::append_number(std::string& out, double value, int level) const {
  if (level >= all_digits || decimals_ == every_digit) return append_shortest(out, value);
  const std::size_t begin = out.size();
  append_fixed(out, value, decimals_ + more_decimals[static_cast<std::size_t>(level)]);
  if (out.find('.', begin) == std::string::npos) return;
  while (out.back() == '0') out.pop_back();
  if (out.back() == '.') out.pop_back();
}

Point VertexRounding::rounded(Point point) const {
  const int level = level_of(point);
  if (level >= all_digits) return point;
  const auto through_text = [&](double value) {
    std::string text;
    append_number(text, value, level);
    return parse_number(text).value;
  };
  return {through_text(point.x), through_text(point.y)};
}

/// Where every vertex has all digits, vertices are written alike where they are alike.
void VertexRounding::append_all_digits(std::string& out, const Ring& ring) {
  out += '[';
  const std::size_t begin = out.size();
  std::size_t end_of_first = begin;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (i > 0 && ring[i] == ring[i - 1]) continue;
    out += i > 0 ? ",[" : "[";
    append_shortest(out, ring[i].x);
    out += ',';
    append_shortest(out, ring[i].y);
    out += ']';
    if (i == 0) end_of_first = out.size();
  }
  if (!ring.empty() && ring.back() != ring.front()) {
    out += ',';
    out.append(out, begin, end_of_first - begin);
  }
  out += ']';
}

void VertexRounding::append(std::string& out, const Ring& ring) const {
  if (decimals_ == every_digit) return append_all_digits(out, ring);
  std::string first;
  std::string before;
  out += '[';
  const auto write = [&](const std::string& text) {
    if (text == before) return;
    if (!before.empty()) out += ',';
    out += text;
    before = text;
  };
  for (const Point point : ring) {
    const int level = level_of(point);
    std::string text = "[";
    append_number(text, point.x, level);
    text += ',';
    append_number(text, point.y, level);
    text += ']';
    if (first.empty()) first = text;
    write(text);
  }
  write(first);
  out += ']';
}

Ring VertexRounding::rounded(const Ring& ring) const {
  Ring result;
  result.reserve(ring.size());
  for (const Point point : ring) {
    const Point written = rounded(point);
    if (result.empty() || result.back() != written) result.push_back(written);
  }
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

int decimals_for(double tolerance) {
  int decimals = 0;
  for (double metres = 1e6; metres > tolerance * 1.0000001 && decimals < 15; metres /= 10)
    ++decimals;
  return std::max(decimals, 1);
}

}  // namespace thiessen
