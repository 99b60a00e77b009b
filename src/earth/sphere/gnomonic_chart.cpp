#include "earth/sphere/gnomonic_chart.h"

#include <array>
#include <cmath>

#include "earth/sphere/conformal_sphere.h"

namespace thiessen {
namespace {

double square_of_scale(double square_sine) {
  const double scale = scale_on_earth(std::sqrt(square_sine));
  return scale * scale;
}

struct Abscissa {
  double of_a;
  double of_b;
  double weight;
};

constexpr double root_of_15 = 3.872983346207417;
constexpr double near_side = (6 - root_of_15) / 21;
constexpr double near_corner = (6 + root_of_15) / 21;
constexpr double side_weight = (155 - root_of_15) / 1200;
constexpr double corner_weight = (155 + root_of_15) / 1200;
constexpr std::array<Abscissa, 7> radon{{{1. / 3, 1. / 3, 9. / 40},
                                         {near_side, near_side, side_weight},
                                         {1 - 2 * near_side, near_side, side_weight},
                                         {near_side, 1 - 2 * near_side, side_weight},
                                         {near_corner, near_corner, corner_weight},
                                         {1 - 2 * near_corner, near_corner, corner_weight},
                                         {near_corner, 1 - 2 * near_corner, corner_weight}}};

}  // namespace

GnomonicChart::GnomonicChart(Direction centre)
    : centre_(centre), square_sine_(centre.z * centre.z) {
  const Direction axis = std::abs(centre.z) < 0.9 ? Direction{0, 0, 1} : Direction{1, 0, 0};
  east_ = unit(cross(axis, centre));
  north_ = cross(centre, east_);
  // The coefficients come from three values, the middle one at the centre except near the equator
  // and the poles.
  constexpr double step = 0.05;
  const double middle = square_sine_ < step       ? step
                        : square_sine_ > 1 - step ? 1 - step
                                                  : square_sine_;
  const double below = square_of_scale(middle - step);
  const double at = square_of_scale(middle);
  const double above = square_of_scale(middle + step);
  const double slope = (above - below) / (2 * step);
  curve_ = (above - 2 * at + below) / (2 * step * step);
  const double off = square_sine_ - middle;
  slope_ = slope + 2 * curve_ * off;
  scale_ = square_of_scale(square_sine_);
}

double GnomonicChart::unit_area(Point p) const {
  const double shrink = 1 / std::sqrt(1 + p.x * p.x + p.y * p.y);
  const double sine = (centre_.z + p.x * east_.z + p.y * north_.z) * shrink;
  const double off = sine * sine - square_sine_;
  return (scale_ + off * (slope_ + off * curve_)) * shrink * shrink * shrink;
}

double ChartSurface::under(Point a, Point b, double /*reference*/) const {
  // Both directions of an edge are computed as one, so that the way back has the same area to the
  // bit.
  const bool back = b < a;
  const Point from = back ? b : a;
  const Point to = back ? a : b;
  double mean = 0;
  for (const Abscissa& x : radon) {
    mean += x.weight *
            chart_.unit_area({x.of_a * from.x + x.of_b * to.x, x.of_a * from.y + x.of_b * to.y});
  }
  const double area = (from.x * to.y - from.y * to.x) / 2 * mean;
  return back ? area : -area;
}

}  // namespace thiessen
