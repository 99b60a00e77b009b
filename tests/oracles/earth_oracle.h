#pragma once

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/NearestNeighbor.hpp>
#include <GeographicLib/PolygonArea.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "geometry/polygon.h"
#include "geometry/predicates.h"

/// GeographicLib as the judge of distances and areas on WGS 84.
namespace thiessen::earth_oracle {

/// Metres, the shortest way.
inline double distance(Point a, Point b) {
  double metres = 0;
  GeographicLib::Geodesic::WGS84().Inverse(a.y, a.x, b.y, b.x, metres);
  return metres;
}

inline Point destination(Point from, double azimuth, double metres) {
  Point to;
  GeographicLib::Geodesic::WGS84().Direct(from.y, from.x, azimuth, metres, to.y, to.x);
  return {from.x + std::remainder(to.x - from.x, 360), to.y};
}

/// GeographicLib's tree of places, by its distances.
class NearestPlace {
 public:
  explicit NearestPlace(const std::vector<Point>& places) : places_(places) {
    tree_.Initialize(places_, distance);
  }
  std::size_t operator()(Point p) const {
    std::vector<int> found;
    tree_.Search(places_, distance, p, found, 1);
    return static_cast<std::size_t>(found.at(0));
  }

 private:
  const std::vector<Point>& places_;
  GeographicLib::NearestNeighbor<double, Point, double (*)(Point, Point)> tree_;
};

/// The area inside edges straight in longitude and latitude, by PolygonArea with `pieces` geodesics
/// for each degree of them.
inline double area_in_pieces(const Ring& ring, int pieces) {
  GeographicLib::PolygonArea polygon(GeographicLib::Geodesic::WGS84());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    const double degrees = std::ceil(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)));
    const int parts = pieces * static_cast<int>(degrees);
    for (int k = 0; k < parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      polygon.AddPoint(a.y + t * (b.y - a.y), a.x + t * (b.x - a.x));
    }
  }
  double perimeter = 0;
  double area = 0;
  polygon.Compute(false, true, perimeter, area);
  return area;
}

/// The limit for ever more pieces, whose error falls with the square of their length: doubled until
/// the limit's guess stays within `allowed`.
inline double area(const Ring& ring, double allowed) {
  double coarse = area_in_pieces(ring, 1);
  double guess = coarse;
  for (int pieces = 2; pieces <= 4096; pieces *= 2) {
    const double fine = area_in_pieces(ring, pieces);
    const double better = fine + (fine - coarse) / 3;
    if (std::abs(better - guess) <= allowed / 4) return better;
    coarse = fine;
    guess = better;
  }
  return guess;
}

inline double area(const MultiPolygon& shape, double allowed) {
  double sum = 0;
  for (const Polygon& part : shape) {
    sum += area(part.outer, allowed);
    for (const Ring& hole : part.holes) sum += area(hole, allowed);
  }
  return sum;
}

/// Which of some shapes hold a point, by the crossings of a parallel, exactly.
class Holders {
 public:
  explicit Holders(const std::vector<const MultiPolygon*>& shapes) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      for (const Polygon& part : *shapes[i]) {
        add(part.outer, i);
        for (const Ring& hole : part.holes) add(hole, i);
      }
    }
  }
  std::vector<std::size_t> of(Point p) const {
    std::map<std::size_t, bool> odd;
    for (const Edge& edge : strips_[strip(p.y)]) {
      if ((edge.from.y <= p.y) == (edge.to.y <= p.y)) continue;
      if ((orientation(edge.from, edge.to, p) > 0) == (edge.to.y > edge.from.y))
        odd[edge.shape] = !odd[edge.shape];
    }
    std::vector<std::size_t> holders;
    for (const auto& [shape, is_odd] : odd) {
      if (is_odd) holders.push_back(shape);
    }
    return holders;
  }

 private:
  struct Edge {
    Point from;
    Point to;
    std::size_t shape;
  };
  static constexpr std::size_t strip_count = 180 * 64;

  static std::size_t strip(double latitude) {
    return std::min(strip_count - 1, static_cast<std::size_t>((latitude + 90) * 64));
  }
  void add(const Ring& ring, std::size_t shape) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Edge edge{ring[i], ring[(i + 1) % ring.size()], shape};
      const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
      for (std::size_t s = strip(low); s <= strip(high); ++s) strips_[s].push_back(edge);
    }
  }

  std::vector<std::vector<Edge>> strips_ = std::vector<std::vector<Edge>>(strip_count);
};

}  // namespace thiessen::earth_oracle
