#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <ostream>

#include "geometry/estimate.h"
#include "geometry/whole_vectors.h"

namespace thiessen {

/// The stages of the predicates' arithmetic, each of which hands on what it cannot decide.
enum class Stage { rounded, exact_doubles, one_limb, two_limbs, seven_limbs };

inline std::ostream& operator<<(std::ostream& out, Stage stage) {
  return out << std::array{"rounded", "exact_doubles", "one_limb", "two_limbs", "seven_limbs"}.at(
             static_cast<std::size_t>(stage));
}

/// The first stage that answers.
template <int Roundings, int Degree, class P, std::size_t Points, class... Coordinates>
Stage stage_of(const Estimate& estimate, const std::array<P, Points>& points,
               Coordinates... coordinates) {
  if (estimate.is_certain_after<Roundings>()) return Stage::rounded;
  if (estimate.is_exact_for<Degree>(coordinates...)) return Stage::exact_doubles;
  const exact::WholeCoordinates<P, Points> whole(points);
  if (whole.template fit<1>()) return Stage::one_limb;
  return whole.template fit<2>() ? Stage::two_limbs : Stage::seven_limbs;
}

/// The sign of determinant(vectors from the last point) at every width that holds them, which is to
/// be the same.
template <class P, std::size_t Points, class Determinant>
int sign_at_all_widths(const std::array<P, Points>& points, Determinant determinant) {
  const exact::WholeCoordinates<P, Points> whole(points);
  EXPECT_TRUE(whole.template fit<7>());
  const int sign = determinant(whole.template differences<7>().to).sign();
  if (whole.template fit<2>()) {
    EXPECT_EQ(determinant(whole.template differences<2>().to).sign(), sign);
  }
  if (whole.template fit<1>()) {
    EXPECT_EQ(determinant(whole.template differences<1>().to).sign(), sign);
  }
  return sign;
}

}  // namespace thiessen
