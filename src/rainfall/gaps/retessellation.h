#pragma once

#include <memory>

#include "rainfall/gaps/gap_policy.h"

namespace thiessen {

class Weigher;

/// A step's values are those of a network of the gauges that report and no others: by their
/// tessellation, or by whatever else the method is. How that is done without weighing each step's
/// gauges from the start is the method's own affair (CellRetessellation, MethodRetessellation).
class Retessellation : public GapPolicy {
 public:
  static constexpr const char* name = "retessellate";
  static std::unique_ptr<const GapPolicy> of(const Weigher& weigher);

  bool leaves_silent_out() const final { return true; }
};

}  // namespace thiessen
