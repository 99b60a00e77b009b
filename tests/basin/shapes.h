#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "basin/basin.h"
#include "geometry/box.h"
#include "geometry/polygon.h"
#include "geometry/seeded.h"

namespace thiessen::shapes {

inline Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

inline Ring rectangle(Point low, Point high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

inline Ring scaled(Ring ring, Point centre, double factor) {
  for (Point& p : ring)
    p = {centre.x + factor * (p.x - centre.x), centre.y + factor * (p.y - centre.y)};
  return ring;
}

/// Counter-clockwise round `centre`, from a third of the radius to all of it.
inline Ring star(Seeded& seeded, Point centre, double radius, std::size_t vertices) {
  Ring ring;
  for (std::size_t i = 0; i < vertices; ++i) {
    const double angle = 2 * M_PI * (static_cast<double>(i) + seeded.uniform(0, 0.9)) /
                         static_cast<double>(vertices);
    const double r = radius * seeded.uniform(0.33, 1);
    ring.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
  }
  return ring;
}

/// The points in their order round `centre`, those of one direction left out: a star's ring.
inline Ring star_through(std::vector<Point> points, Point centre) {
  const auto angle = [&](Point p) { return std::atan2(p.y - centre.y, p.x - centre.x); };
  std::sort(points.begin(), points.end(), [&](Point p, Point q) { return angle(p) < angle(q); });
  Ring ring;
  for (const Point p : points) {
    if (p != centre && (ring.empty() || angle(p) - angle(ring.back()) > 1e-6)) ring.push_back(p);
  }
  double widest = ring.size() < 3 ? 7 : angle(ring.front()) - angle(ring.back()) + 2 * M_PI;
  for (std::size_t i = 1; i < ring.size(); ++i)
    widest = std::max(widest, angle(ring[i]) - angle(ring[i - 1]));
  return widest < M_PI ? ring : Ring{};
}

/// Columns of unit cells side by side: a staircase above and below, from (0, 0), in steps of
/// `step`.
inline Ring staircase(Seeded& seeded, Point origin, double step, int columns, int height) {
  std::vector<std::pair<int, int>> spans;
  for (int i = 0; i < columns; ++i) {
    int low = static_cast<int>(seeded.whole(0, height - 1));
    int high = static_cast<int>(seeded.whole(low + 1, height));
    if (!spans.empty()) {
      low = std::min(low, spans.back().second - 1);
      high = std::max(high, spans.back().first + 1);
    }
    spans.emplace_back(low, high);
  }
  const auto at = [&](int column, int row) {
    return Point{origin.x + step * column, origin.y + step * row};
  };
  Ring ring;
  const auto add = [&](Point p) {
    if (ring.empty() || ring.back() != p) ring.push_back(p);
  };
  for (int i = 0; i < columns; ++i) {
    add(at(i, spans[static_cast<std::size_t>(i)].first));
    add(at(i + 1, spans[static_cast<std::size_t>(i)].first));
  }
  for (int i = columns - 1; i >= 0; --i) {
    add(at(i + 1, spans[static_cast<std::size_t>(i)].second));
    add(at(i, spans[static_cast<std::size_t>(i)].second));
  }
  return ring;
}

/// Von Koch's snowflake with 3 * 4^level vertices.
inline Ring snowflake(Point centre, double radius, int level) {
  Ring ring;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * M_PI * i / 3 + 0.1;
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  for (int l = 0; l < level; ++l) {
    Ring finer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      const Point d{(b.x - a.x) / 3, (b.y - a.y) / 3};
      finer.push_back(a);
      finer.push_back({a.x + d.x, a.y + d.y});
      // Outwards: to the right.
      finer.push_back(
          {a.x + 1.5 * d.x + d.y * std::sqrt(0.75), a.y + 1.5 * d.y - d.x * std::sqrt(0.75)});
      finer.push_back({a.x + 2 * d.x, a.y + 2 * d.y});
    }
    ring = std::move(finer);
  }
  return ring;
}

/// A bar with `teeth` long teeth up.
inline Ring comb(Point low, double width, double height, int teeth) {
  Ring ring{low, {low.x + width, low.y}};
  const double pitch = width / teeth;
  for (int i = teeth - 1; i >= 0; --i) {
    const double left = low.x + i * pitch;
    if (i < teeth - 1) ring.push_back({left + pitch, low.y + height / 10});
    ring.push_back({i < teeth - 1 ? left + pitch : low.x + width, low.y + height});
    ring.push_back({left + pitch / 2, low.y + height});
    ring.push_back({left + pitch / 2, low.y + height / 10});
  }
  ring.push_back({low.x, low.y + height / 10});
  return ring;
}

/// Small stars in a grid, and every third with a hole.
inline MultiPolygon islands(Seeded& seeded, Point low, double pitch, int side) {
  MultiPolygon parts;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const Point centre{low.x + pitch * (column + 0.5), low.y + pitch * (row + 0.5)};
      Polygon island{star(seeded, centre, 0.49 * pitch, 9), {}};
      if ((row + column) % 3 == 0)
        island.holes.push_back(reversed(scaled(island.outer, centre, 0.4)));
      parts.push_back(std::move(island));
    }
  }
  return parts;
}

inline Box box_of(const MultiPolygon& shape) {
  Box box;
  for (const Polygon& part : shape) {
    for (const Point p : part.outer) box.take_in(p);
  }
  return box;
}

inline Basin basin(MultiPolygon shape) {
  return {"basin", std::move(shape), {}};
}

}  // namespace thiessen::shapes
