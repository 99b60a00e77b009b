#include "earth/bisector_arc.h"

namespace thiessen {

BisectorArc::BisectorArc(Direction first, Direction second, Direction chord) {
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

double BisectorArc::angle_of(Direction p) const {
  return std::atan2(dot(p, left_), dot(p, middle_));
}

}  // namespace thiessen
