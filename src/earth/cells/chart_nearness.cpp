#include "earth/cells/chart_nearness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "earth/sphere/conformal_sphere.h"

namespace thiessen {
namespace {

constexpr std::size_t degree = 4;
constexpr std::size_t terms = 15;  // of a polynomial of that degree
constexpr double accuracy = 1e-6;  // metres, of distances
constexpr double farthest = 0.5;   // radians

using Terms = std::array<double, terms>;

/// The powers of a polynomial, by degree and then with fewer x, as Nearness has them.
Terms powers_at(Point p) {
  Terms powers{};
  std::size_t term = 0;
  for (std::size_t sum = 0; sum <= degree; ++sum) {
    for (std::size_t of_y = 0; of_y <= sum; ++of_y) {
      double power = 1;
      for (std::size_t i = 0; i < sum; ++i) power *= i < of_y ? p.y : p.x;
      powers[term++] = power;
    }
  }
  return powers;
}

/// The Padua points in the square from -1 to 1, and how to find a polynomial by its values there.
class PaduaPoints {
 public:
  PaduaPoints() {
    std::size_t next = 0;
    for (std::size_t i = 0; i <= degree; ++i) {
      for (std::size_t k = i % 2; k <= degree + 1; k += 2) {
        points_[next++] = {std::cos(std::numbers::pi * static_cast<double>(i) / degree),
                           std::cos(std::numbers::pi * static_cast<double>(k) / (degree + 1))};
      }
    }
    invert();
  }

  const std::array<Point, terms>& points() const { return points_; }
  /// The coefficients of the polynomial that has these values at the points.
  Terms polynomial(const Terms& values) const {
    Terms coefficients{};
    for (std::size_t point = 0; point < terms; ++point) {
      for (std::size_t term = 0; term < terms; ++term)
        coefficients[term] += by_value_[point][term] * values[point];
    }
    return coefficients;
  }

 private:
  // Gauss and Jordan's elimination, with the largest pivot of each column.
  void invert() {
    std::array<Terms, terms> rows{};
    std::array<Terms, terms> inverse{};
    for (std::size_t i = 0; i < terms; ++i) {
      rows[i] = powers_at(points_[i]);
      inverse[i][i] = 1;
    }
    for (std::size_t column = 0; column < terms; ++column) {
      std::size_t pivot = column;
      for (std::size_t i = column + 1; i < terms; ++i) {
        if (std::abs(rows[i][column]) > std::abs(rows[pivot][column])) pivot = i;
      }
      std::swap(rows[column], rows[pivot]);
      std::swap(inverse[column], inverse[pivot]);
      const double by = 1 / rows[column][column];
      for (std::size_t k = 0; k < terms; ++k) {
        rows[column][k] *= by;
        inverse[column][k] *= by;
      }
      for (std::size_t i = 0; i < terms; ++i) {
        const double times = rows[i][column];
        if (i == column || times == 0) continue;
        for (std::size_t k = 0; k < terms; ++k) {
          rows[i][k] -= times * rows[column][k];
          inverse[i][k] -= times * inverse[column][k];
        }
      }
    }
    for (std::size_t i = 0; i < terms; ++i) {
      for (std::size_t k = 0; k < terms; ++k) by_value_[k][i] = inverse[i][k];
    }
  }

  std::array<Point, terms> points_{};
  std::array<Terms, terms> by_value_{};  // by point, then by term
};

const PaduaPoints& padua_points() {
  static const PaduaPoints points;
  return points;
}

double distance(const EarthPoint& place, double scale_at_place, Direction at) {
  const double half = length(at - place.direction) / 2;
  if (!is_short_path(half, accuracy)) return sphere_arrival(place, at, accuracy).distance;
  const SphereScale& scale = sphere_scale();
  return short_path(scale, {place.direction, scale_at_place}, {at, scale.at(at.z)}, half);
}

}  // namespace

ChartNearness::ChartNearness(const GnomonicChart& chart, double reach)
    : chart_(chart), reach_(reach), scale_(scale_on_earth(chart.centre().z)) {}

std::optional<Nearness> ChartNearness::of(const EarthPoint& place) const {
  const Direction off = place.direction - chart_.centre();
  if (length(off) > farthest) return {};
  const double scale_at_place = sphere_scale().at(place.direction.z);
  const PaduaPoints& padua = padua_points();
  Terms values{};
  for (std::size_t i = 0; i < terms; ++i) {
    const Point p{reach_ * padua.points()[i].x, reach_ * padua.points()[i].y};
    const Direction at = chart_.direction(p);
    const double sine = std::sin(distance(place, scale_at_place, at) / (2 * scale_));
    const double half = length(at - place.direction) / 2;
    values[i] = 2 * std::sqrt(1 + p.x * p.x + p.y * p.y) * (sine - half) * (sine + half);
  }
  const Terms added = padua.polynomial(values);
  Nearness nearness;
  nearness.straight = {dot(off, off) / 2 + added[0], -dot(off, chart_.east()) + added[1] / reach_,
                       -dot(off, chart_.north()) + added[2] / reach_};
  double of_reach = reach_ * reach_;
  std::size_t term = 3;
  for (std::size_t sum = 2; sum <= degree; ++sum) {
    for (std::size_t i = 0; i <= sum; ++i, ++term) {
      nearness.bent[term - 3] = added[term] / of_reach;
      nearness.most_bent += std::abs(added[term]);
    }
    of_reach *= reach_;
  }
  return nearness;
}

}  // namespace thiessen
