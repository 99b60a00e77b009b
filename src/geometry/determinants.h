#pragma once

namespace thiessen {

/// A vector of the plane, whose components are doubles, whole numbers or estimates.
template <class Number>
struct PlaneVector {
  Number x;
  Number y;
};

/// A vector of space, whose components are doubles, whole numbers or estimates.
template <class Number>
struct SpaceVector {
  Number x;
  Number y;
  Number z;
};

/// The determinants whose signs the predicates return. One formula serves every arithmetic: a
/// number needs +, - and *, whose results may be of wider types.
namespace determinant {

/// The square of the vector's length.
template <class Number>
auto square(const PlaneVector<Number>& u) {
  return u.x * u.x + u.y * u.y;
}
template <class Number>
auto square(const SpaceVector<Number>& u) {
  return u.x * u.x + u.y * u.y + u.z * u.z;
}

/// Twice the signed area of the triangle 0, u, v.
template <class Number>
auto area(const PlaneVector<Number>& u, const PlaneVector<Number>& v) {
  return u.x * v.y - u.y * v.x;
}

/// The cross product of u and v: twice the signed areas of the triangle 0, u, v projected along
/// each axis.
template <class Number>
auto cross(const SpaceVector<Number>& u, const SpaceVector<Number>& v) {
  using Area = decltype(u.x * v.y - u.y * v.x);
  return SpaceVector<Area>{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// Six times the signed volume of the tetrahedron 0, u, v, w.
template <class Number>
auto volume(const SpaceVector<Number>& u, const SpaceVector<Number>& v,
            const SpaceVector<Number>& w) {
  const auto vw = v.x * w.y - v.y * w.x;
  const auto wu = w.x * u.y - w.y * u.x;
  const auto uv = u.x * v.y - u.y * v.x;
  return u.z * vw + v.z * wu + w.z * uv;
}

/// The in-circle determinant: positive where 0 is inside the circle through u, v, w. Requires that
/// these turn left. The squares are those of u, v and w, or of vectors in space whose projections
/// these are.
template <class Square, class Number>
auto in_circle(const Square& u_square, const PlaneVector<Number>& u, const Square& v_square,
               const PlaneVector<Number>& v, const Square& w_square, const PlaneVector<Number>& w) {
  return u_square * area(v, w) + v_square * area(w, u) + w_square * area(u, v);
}
template <class Number>
auto in_circle(const PlaneVector<Number>& u, const PlaneVector<Number>& v,
               const PlaneVector<Number>& w) {
  return in_circle(square(u), u, square(v), v, square(w), w);
}

/// The in-sphere determinant: positive where 0 is inside the sphere through a, b, c, d. Requires
/// that their orientation is positive.
template <class Number>
auto in_sphere(const SpaceVector<Number>& a, const SpaceVector<Number>& b,
               const SpaceVector<Number>& c, const SpaceVector<Number>& d) {
  const auto ab = a.x * b.y - a.y * b.x;
  const auto bc = b.x * c.y - b.y * c.x;
  const auto cd = c.x * d.y - c.y * d.x;
  const auto da = d.x * a.y - d.y * a.x;
  const auto ac = a.x * c.y - a.y * c.x;
  const auto bd = b.x * d.y - b.y * d.x;
  const auto abc = a.z * bc - b.z * ac + c.z * ab;
  const auto bcd = b.z * cd - c.z * bd + d.z * bc;
  const auto cda = c.z * da + d.z * ac + a.z * cd;
  const auto dab = d.z * ab + a.z * bd + b.z * da;
  return (square(a) * bcd - square(b) * cda) + (square(c) * dab - square(d) * abc);
}

}  // namespace determinant
}  // namespace thiessen
