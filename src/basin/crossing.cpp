#include "basin/crossing.h"

#include <algorithm>

#include "geometry/box.h"
#include "geometry/predicates.h"
#include "geometry/segment.h"

namespace thiessen {
namespace {

int sign_of(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

// The side of the shifted edge a→b on which a point of the edge's unshifted line lies.
int side_of_shifted_edge(Point a, Point b) {
  return a.y != b.y ? sign_of(b.y - a.y) : -sign_of(b.x - a.x);
}

// The side of a chord on which a point of its line lies once the point is shifted.
int side_of_chord_when_shifted(Point from, Point to) {
  return -side_of_shifted_edge(from, to);
}

Point held_in(const Box& box, Point p) {
  return {std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y)};
}

}  // namespace

Meeting meet(Point a, Point b, Point from, Point to) {
  Meeting meeting;
  const Box edge_box = box_of(a, b);
  const Box chord_box = box_of(from, to);
  const int side_of_from = orientation(a, b, from);
  const int side_of_to = orientation(a, b, to);
  if (side_of_from * side_of_to > 0) return meeting;
  const int side_of_a = orientation(from, to, a);
  const int side_of_b = orientation(from, to, b);
  meeting.from_on_edge = side_of_from == 0 && edge_box.contains(from);
  meeting.to_on_edge = side_of_to == 0 && edge_box.contains(to);
  meeting.a_on_chord = side_of_a == 0 && chord_box.contains(a);
  meeting.b_on_chord = side_of_b == 0 && chord_box.contains(b);

  const bool from_is_left = (side_of_from != 0 ? side_of_from : side_of_shifted_edge(a, b)) > 0;
  const bool to_is_left = (side_of_to != 0 ? side_of_to : side_of_shifted_edge(a, b)) > 0;
  const bool a_is_left = (side_of_a != 0 ? side_of_a : side_of_chord_when_shifted(from, to)) > 0;
  const bool b_is_left = (side_of_b != 0 ? side_of_b : side_of_chord_when_shifted(from, to)) > 0;
  if (from_is_left == to_is_left || a_is_left == b_is_left) return meeting;

  const double from_area = doubled_area(a, b, from);
  const double to_area = doubled_area(a, b, to);
  const double a_area = doubled_area(from, to, a);
  const double b_area = doubled_area(from, to, b);
  Crossing crossing{};
  crossing.along_chord = from_area / (from_area - to_area);
  crossing.along_edge = a_area / (a_area - b_area);
  crossing.to_left = b_is_left;
  crossing.entering = to_is_left;
  if (side_of_from == 0) {
    crossing.point = from;
  } else if (side_of_to == 0) {
    crossing.point = to;
  } else if (side_of_a == 0) {
    crossing.point = a;
  } else if (side_of_b == 0) {
    crossing.point = b;
  } else {
    const bool nearer_from = crossing.along_chord <= 0.5;
    const Point p = nearer_from ? between(from, to, crossing.along_chord)
                                : between(to, from, to_area / (to_area - from_area));
    crossing.point = held_in(chord_box, held_in(edge_box, p));
  }
  meeting.crossing = crossing;
  return meeting;
}

}  // namespace thiessen
