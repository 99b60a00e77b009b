#include "earth/cells/geodesic_dual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "earth/cells/border_length.h"
#include "earth/cells/geodesic_vertices.h"
#include "earth/sphere/geodesic.h"
#include "earth/sphere/sphere_tessellation.h"
#include "earth/sphere/units.h"
#include "geometry/box.h"

namespace thiessen {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Box whole_earth{{-180, -90}, {180, 90}};

class GeodesicDual {
 public:
  GeodesicDual(std::span<const Point> places, double accuracy, unsigned threads)
      : places_(places), sphere_(places), accuracy_(accuracy), threads_(threads) {}

  Dual find() && {
    const Span span = sphere_.tessellation().span();
    if (span == Span::point) add_closed_border();
    if (span == Span::line || span == Span::plane) {
      const GeodesicVertices vertices(sphere_, places_, whole_earth, accuracy_, threads_);
      add_triangles(vertices.mesh());
      add_borders(vertices);
    }
    put_in_order(dual_);
    return std::move(dual_);
  }

 private:
  Point position(PlaceIndex p) const { return places_[index(p)]; }

  // The border of two places closes on itself.
  void add_closed_border() {
    const PlaceIndex first = sphere_.pole();
    const PlaceIndex second = sphere_.place(sphere_.tessellation().along_line().front());
    const GeodesicBisector bisector(EarthPoint(position(first)), EarthPoint(position(second)),
                                    sphere_.bisector(first, second), accuracy_);
    const Point start = bisector.find(pi).position;
    const Point middle = bisector.find(0).position;
    dual_.borders.push_back({first, second,
                             border_length(bisector, {-pi, start}, {0, middle}) +
                                 border_length(bisector, {0, middle}, {pi, start})});
  }

  void add_triangles(const CellMesh& mesh) {
    for (std::uint32_t t = 0; t < mesh.triangles(); ++t) {
      if (has_inside(mesh.corners(t))) dual_.triangles.push_back(mesh.corners(t));
    }
  }

  // Whether the triangle has its inside to the left of its sides, where it is wider than a
  // micrometre.
  bool has_inside(const std::array<PlaceIndex, 3>& corners) const {
    constexpr double narrowest = 1e-6 / mean_radius;
    const auto [a, b, c] = sphere_.in_order(corners);
    const Direction to_b = sphere_.chord(a, b, 1e-12);
    const Direction to_c = sphere_.chord(a, c, 1e-12);
    const double longest = std::max({length(to_b), length(to_c), length(to_c - to_b)});
    return dot(sphere_.direction(a), cross(to_b, to_c)) > narrowest * longest;
  }

  // Sides are measured in pieces of a fixed length, for the borders of each to stand in its own
  // list, whatever the number of threads.
  void add_borders(const GeodesicVertices& vertices) {
    constexpr std::uint32_t sides_a_piece = 300;
    const CellMesh& mesh = vertices.mesh();
    const std::size_t pieces = (mesh.sides() + sides_a_piece - 1) / sides_a_piece;
    std::vector<std::vector<Border>> borders(pieces);
    in_parallel(pieces, threads_, [&](std::size_t, std::size_t piece) {
      const auto first = static_cast<std::uint32_t>(piece * sides_a_piece);
      const std::uint32_t end = std::min(mesh.sides(), first + sides_a_piece);
      mesh.for_each_edge(first, end, [&](SideIndex s) { add_border(vertices, s, borders[piece]); });
    });
    for (const auto& piece : borders)
      dual_.borders.insert(dual_.borders.end(), piece.begin(), piece.end());
  }

  void add_border(const GeodesicVertices& vertices, SideIndex s,
                  std::vector<Border>& borders) const {
    const auto border = vertices.border(s);
    if (!border) return;
    const auto& [left, right, start, end] = *border;
    const GeodesicBisector bisector = vertices.edge(left, right);
    const auto [from, to] = vertices.angles(bisector, start, end);
    const double length =
        border_length(bisector, {from, vertices.position(start)}, {to, vertices.position(end)});
    // Each end is right to ten times the accuracy: what is shorter than that twice may be none.
    if (length > 20 * accuracy_) borders.push_back({left, right, length});
  }

  std::span<const Point> places_;
  SphereTessellation sphere_;
  double accuracy_;
  unsigned threads_;
  Dual dual_;
};

}  // namespace

Dual geodesic_dual(std::span<const Point> places, double accuracy, unsigned threads) {
  return GeodesicDual(places, accuracy, threads).find();
}

}  // namespace thiessen
