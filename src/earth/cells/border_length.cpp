#include "earth/cells/border_length.h"

#include "base/interrupt.h"
#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

constexpr double longest_piece = 0.02;   // radians
constexpr double shortest_piece = 1e-6;  // radians, six metres
constexpr double share_that_tells = 1e-9;
constexpr double metres_that_tell = 1e-6;

double piece_length(const GeodesicBisector& bisector, const BisectorEnd& from,
                    const BisectorEnd& to) {
  throw_if_interrupted();
  const double angle = to.angle - from.angle;
  const double straight = geodesic_distance(from.position, to.position);
  if (angle <= shortest_piece) return straight;
  const double middle_angle = from.angle + angle / 2;
  const BisectorEnd middle{middle_angle, bisector.find(middle_angle).position};
  const double halves = geodesic_distance(from.position, middle.position) +
                        geodesic_distance(middle.position, to.position);
  const bool tells_no_more = halves - straight <= share_that_tells * halves + metres_that_tell;
  if (angle <= longest_piece && tells_no_more) return halves + (halves - straight) / 3;
  return piece_length(bisector, from, middle) + piece_length(bisector, middle, to);
}

}  // namespace

double border_length(const GeodesicBisector& bisector, const BisectorEnd& from,
                     const BisectorEnd& to) {
  return piece_length(bisector, from, to);
}

}  // namespace thiessen
