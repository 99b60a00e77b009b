#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "oracles/delaunay_complex.h"
#include "tessellation/simplices.h"

namespace thiessen {

/// The tessellation is CGAL's of the same points up to ties, exactly: see DelaunayComplex.
template <int Dimension>
void expect_same_as_cgal(const Tessellation<Dimension>& tessellation) {
  const std::vector<PositionIn<Dimension>> points = positions_of(tessellation);
  const auto triangulation =
      cgal::triangulation_of<Dimension>(std::span<const PositionIn<Dimension>>(points));
  ASSERT_EQ(tessellation.topology().dimension(), triangulation.dimension());
  ASSERT_EQ(tessellation.count(), triangulation.number_of_vertices());
  if (tessellation.topology().dimension() < 1) return;
  const auto ours = cgal::complex_of(cgal::division_of(tessellation));
  const auto theirs = cgal::complex_of(cgal::division_of(triangulation));
  ASSERT_TRUE(ours.is_delaunay);
  ASSERT_TRUE(theirs.is_delaunay);
  ASSERT_EQ(ours.cells.size(), theirs.cells.size());
  ASSERT_TRUE(ours.cells == theirs.cells);
}

/// Of these points, sound and as CGAL's.
template <int Dimension>
void expect_sound_and_same_as_cgal(const std::vector<PositionIn<Dimension>>& points) {
  const Tessellation<Dimension> tessellation = tessellation_of(points);
  ASSERT_EQ(positions_of(tessellation), distinct(points));
  const auto findings = audit(tessellation);
  ASSERT_TRUE(findings.empty()) << name_of(findings.front().fault);
  expect_same_as_cgal(tessellation);
}

}  // namespace thiessen
