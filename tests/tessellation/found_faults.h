#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tessellation/audit.h"

namespace thiessen {

template <int Dimension>
bool finds(const std::vector<Finding<Dimension>>& findings, Fault fault) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const auto& f) { return f.fault == fault; });
}

/// That the audit finds the fault, and shows forming points of the vertices at which it is.
template <int Dimension>
void expect_found(const Structure<Dimension>& structure, Fault fault) {
  const auto findings = audit(structure);
  EXPECT_TRUE(finds(findings, fault)) << name_of(fault);
  for (const Finding<Dimension>& f : findings) {
    if (f.vertex == no_vertex || f.fault == Fault::point_without_simplex) continue;
    bool is_there = false;
    for (const PointId p : structure.topology().forming(f.vertex)) {
      if (p == infinite_point || !structure.topology().is_there(p)) continue;
      is_there = is_there || structure.position(p) == f.position;
    }
    EXPECT_TRUE(is_there) << name_of(f.fault);
  }
}

}  // namespace thiessen
