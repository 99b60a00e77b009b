#include "rainfall/gaps/cell_weigher.h"

#include "rainfall/gaps/cell_retessellation.h"

namespace thiessen {

std::vector<BasinWeights> CellWeigher::full_weights() const {
  return weighing_.weights(ReportingStations(network().stations().size(), true), threads_);
}

const Handovers& CellWeigher::handovers() const {
  std::call_once(once_,
                 [&] { handovers_ = std::make_unique<const Handovers>(weighing_, threads_); });
  return *handovers_;
}

std::unique_ptr<const Retessellation> CellWeigher::retessellation() const {
  return std::make_unique<const CellRetessellation>(handovers(), keeping_.remembered_bytes,
                                                    keeping_.counts_gauges);
}

}  // namespace thiessen
