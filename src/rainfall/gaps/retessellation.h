#pragma once

#include <memory>

#include "rainfall/gaps/gap_policy.h"
#include "rainfall/normals/normal_field.h"

namespace thiessen {

class Weigher;

/// Gives a step the values of a network that consists of the gauges that report and no others: by
/// their tessellation, or by another method. It is left to each method how to do this without
/// weighing the gauges of each step from the start (CellRetessellation, MethodRetessellation).
class Retessellation : public GapPolicy {
 public:
  static constexpr const char* name = "retessellate";
  static std::unique_ptr<const GapPolicy> of(const Weigher& weigher, const NormalMonth& month);

  bool leaves_silent_out() const final { return true; }
};

}  // namespace thiessen
