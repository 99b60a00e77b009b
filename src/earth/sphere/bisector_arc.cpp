#include "earth/sphere/bisector_arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thiessen {

BisectorArc::BisectorArc(Direction first, Direction second, Direction chord)
    : half_separation_(std::asin(std::min(1.0, length(chord) / 2))) {
  const Direction forward = unit(chord);
  const Direction sum = first + second;
  if (length(sum) > 1e-9) {
    middle_ = unit(sum);
  } else {
    const Direction axis = std::abs(forward.z) < 0.5 ? Direction{0, 0, 1} : Direction{1, 0, 0};
    middle_ = unit(cross(axis, forward));
  }
  left_ = cross(middle_, forward);
}

Direction BisectorArc::at(double angle) const {
  return std::cos(angle) * middle_ + std::sin(angle) * left_;
}

Direction BisectorArc::at(double angle, double offset) const {
  return offset == 0 ? at(angle) : std::cos(offset) * at(angle) + std::sin(offset) * forward();
}

Direction BisectorArc::across(double angle, double offset) const {
  return std::cos(offset) * forward() - std::sin(offset) * at(angle);
}

double BisectorArc::angle_of(Direction p) const {
  return std::atan2(dot(p, left_), dot(p, middle_));
}

std::pair<double, double> BisectorArc::between(Direction start, Direction end) const {
  constexpr double pi = std::numbers::pi;
  const double from = angle_of(start);
  // A large turn backward stands for one forward by the rest of the circle; a small one comes from
  // rounding.
  double turn = std::remainder(angle_of(end) - from, 2 * pi);
  if (turn < -pi / 2) turn += 2 * pi;
  return {from, from + std::max(turn, 0.0)};
}

}  // namespace thiessen
