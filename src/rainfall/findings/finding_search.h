#pragma once

#include <functional>

#include "rainfall/findings/reading_finding.h"
#include "rainfall/findings/seen_step.h"
#include "rainfall/findings/stretch.h"

namespace thiessen {

/// Where a search takes what it finds.
using TakeFinding = std::function<void(ReadingFinding)>;

/// Looks for one kind of readings that cannot be true, in readings that pass once, step by step, in
/// memory that does not grow with their number.
class FindingSearch {
 public:
  virtual ~FindingSearch() = default;
  /// Looks at the next step: of single readings.
  virtual void see(const SeenStep& /*step*/, const TakeFinding& /*take*/) {}
  /// Looks at the next stretch: of whole gauges. Each step is in one.
  virtual void see(const Stretch& /*stretch*/) {}
  /// Tells what only the whole record shows.
  virtual void conclude(const TakeFinding& /*take*/) {}
};

}  // namespace thiessen
