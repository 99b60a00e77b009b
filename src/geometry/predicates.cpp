#include "geometry/predicates.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/expansion.h"

namespace thiessen {
namespace {

using exact::difference;

constexpr double half_ulp = 0x1p-53;
constexpr double orientation_bound = (3 + 16 * half_ulp) * half_ulp;
constexpr double distance_bound = (5 + 32 * half_ulp) * half_ulp;
constexpr double in_circle_bound = (10 + 96 * half_ulp) * half_ulp;
// Above this share of the sum of its terms' magnitudes, a determinant computed in doubles is right
// to 2^-48.
constexpr double trusted_share = 1.0 / 8;

int sign_of(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

Expansion<16> exact_doubled_area(Point a, Point b, Point c) {
  return difference(a.x, c.x) * difference(b.y, c.y) - difference(a.y, c.y) * difference(b.x, c.x);
}

int exact_in_circle(Point a, Point b, Point c, Point d) {
  const auto adx = difference(a.x, d.x), ady = difference(a.y, d.y);
  const auto bdx = difference(b.x, d.x), bdy = difference(b.y, d.y);
  const auto cdx = difference(c.x, d.x), cdy = difference(c.y, d.y);
  const auto a_lift = adx * adx + ady * ady;
  const auto b_lift = bdx * bdx + bdy * bdy;
  const auto c_lift = cdx * cdx + cdy * cdy;
  const auto bc = bdx * cdy - bdy * cdx;
  const auto ca = cdx * ady - cdy * adx;
  const auto ab = adx * bdy - ady * bdx;
  return (a_lift * bc + b_lift * ca + c_lift * ab).sign();
}

/// u * v - s * t, where the factors are exact, to 2^-48.
template <std::size_t N, std::size_t M>
double accurate_determinant(const Expansion<N>& u, const Expansion<M>& v, const Expansion<N>& s,
                            const Expansion<M>& t) {
  const double left = u.estimate() * v.estimate();
  const double right = s.estimate() * t.estimate();
  const double value = left - right;
  if (std::abs(value) >= trusted_share * (std::abs(left) + std::abs(right))) return value;
  return (u * v - s * t).estimate();
}

}  // namespace

int orientation(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double value = left - right;
  if (std::abs(value) > orientation_bound * (std::abs(left) + std::abs(right)))
    return sign_of(value);
  return exact_doubled_area(a, b, c).sign();
}

double doubled_area(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double value = left - right;
  if (std::abs(value) >= trusted_share * (std::abs(left) + std::abs(right))) return value;
  return exact_doubled_area(a, b, c).estimate();
}

int in_circle(Point a, Point b, Point c, Point d) {
  const double adx = a.x - d.x, ady = a.y - d.y;
  const double bdx = b.x - d.x, bdy = b.y - d.y;
  const double cdx = c.x - d.x, cdy = c.y - d.y;
  const double a_lift = adx * adx + ady * ady;
  const double b_lift = bdx * bdx + bdy * bdy;
  const double c_lift = cdx * cdx + cdy * cdy;
  const double value = a_lift * (bdx * cdy - bdy * cdx) + b_lift * (cdx * ady - cdy * adx) +
                       c_lift * (adx * bdy - ady * bdx);
  const double magnitude = a_lift * (std::abs(bdx * cdy) + std::abs(bdy * cdx)) +
                           b_lift * (std::abs(cdx * ady) + std::abs(cdy * adx)) +
                           c_lift * (std::abs(adx * bdy) + std::abs(ady * bdx));
  if (std::abs(value) > in_circle_bound * magnitude) return sign_of(value);
  return exact_in_circle(a, b, c, d);
}

bool in_perturbed_circle(Point a, Point b, Point c, Point d) {
  const int side = in_circle(a, b, c, d);
  if (side != 0) return side > 0;
  // The highest lift decides, unless its coefficient in the determinant, an orientation, is zero.
  // Lifting d makes it outside; lifting a corner makes d inside where d sees the other two as the
  // corner does.
  std::array<int, 4> order{0, 1, 2, 3};
  const std::array<Point, 4> points{a, b, c, d};
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return points[static_cast<std::size_t>(i)] > points[static_cast<std::size_t>(j)];
  });
  for (const int highest : order) {
    int coefficient = -1;
    if (highest == 0) coefficient = orientation(d, b, c);
    if (highest == 1) coefficient = orientation(a, d, c);
    if (highest == 2) coefficient = orientation(a, b, d);
    if (coefficient != 0) return coefficient > 0;
  }
  return false;
}

int compare_distance(Point from, Point a, Point b) {
  const double ax = a.x - from.x, ay = a.y - from.y;
  const double bx = b.x - from.x, by = b.y - from.y;
  const double a_square = ax * ax + ay * ay;
  const double b_square = bx * bx + by * by;
  const double value = a_square - b_square;
  if (std::abs(value) > distance_bound * (a_square + b_square)) return sign_of(value);
  const auto aex = difference(a.x, from.x), aey = difference(a.y, from.y);
  const auto bex = difference(b.x, from.x), bey = difference(b.y, from.y);
  return ((aex * aex + aey * aey) - (bex * bex + bey * bey)).sign();
}

Point circumcentre(Point a, Point b, Point c) {
  if (b < a) std::swap(a, b);
  if (c < a) std::swap(a, c);
  if (c < b) std::swap(b, c);
  const auto bx = difference(b.x, a.x), by = difference(b.y, a.y);
  const auto cx = difference(c.x, a.x), cy = difference(c.y, a.y);
  const auto b_square = bx * bx + by * by;
  const auto c_square = cx * cx + cy * cy;
  const double area = accurate_determinant(bx, cy, cx, by);
  const double east = accurate_determinant(b_square, cy, c_square, by);
  const double north = accurate_determinant(c_square, bx, b_square, cx);
  return {a.x + east / (2 * area), a.y + north / (2 * area)};
}

}  // namespace thiessen
