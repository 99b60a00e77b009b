#include "earth/cells/bisector_offset.h"

#include <cmath>

#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/units.h"

namespace thiessen {
namespace {

// The inner points of the piece, as shares of its length, in the order in which they are tried.
// They lie closer together towards the ends, as on a Chebyshev grid, because polynomials swing
// there.
constexpr std::array<double, 5> inner{0.5, 0.15, 0.85, 0.32, 0.68};

}  // namespace

std::optional<BisectorOffset> BisectorOffset::fit(const GeodesicBisector& edge, double from,
                                                  Point start, double to, Point end) {
  const double near_enough = 10 * edge.accuracy() / mean_radius;
  BisectorOffset offset(edge.arc());
  if (!(from < to)) return {};
  offset.take({from, offset.offset_of(start)});
  offset.take({to, offset.offset_of(end)});
  for (const double share : inner) {
    const double angle = from + share * (to - from);
    const BisectorPoint found = edge.find(angle, offset.offset_at(angle));
    if (!found.is_exact) return {};
    const double missed = std::abs(offset.offset_at(angle) - found.offset);
    offset.take({angle, found.offset});
    // The middle alone would not show a curve shaped like an S, so fewer samples must agree more
    // closely.
    const double allowed = offset.samples_ > 3 ? near_enough : near_enough / 10;
    if (missed <= allowed + 2 * found.uncertainty) return offset;
  }
  return {};
}

double BisectorOffset::offset_of(Point p) const {
  return std::asin(dot(on_sphere(p), arc_.forward()));
}

void BisectorOffset::take(Sample sample) {
  double difference = sample.offset;
  for (std::size_t i = 0; i < samples_; ++i)
    difference = (difference - differences_[i]) / (sample.angle - angles_[i]);
  angles_[samples_] = sample.angle;
  differences_[samples_] = difference;
  ++samples_;
}

double BisectorOffset::offset_at(double angle) const {
  double offset = 0;
  for (std::size_t i = samples_; i-- > 0;) offset = differences_[i] + (angle - angles_[i]) * offset;
  return offset;
}

Point BisectorOffset::at(double angle) const {
  return from_sphere(arc_.at(angle, offset_at(angle)));
}

}  // namespace thiessen
