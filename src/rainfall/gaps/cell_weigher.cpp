#include "rainfall/gaps/cell_weigher.h"

#include "rainfall/gaps/cell_retessellation.h"

namespace thiessen {

std::vector<BasinWeights> CellWeigher::full_weights(const NormalMonth& month) const {
  const ReportingStations all(network().stations().size(), true);
  if (!month) return weighing_.weights(all, threads_);
  std::call_once(weighed_, [&] { by_month_ = weighing_.weights_by_month(all, threads_); });
  return by_month_[*month];
}

const Handovers& CellWeigher::handovers() const {
  std::call_once(once_, [&] {
    handovers_ = std::make_unique<const Handovers>(weighing_, threads_);
    remembered_ = std::make_unique<HandoverCache>(*handovers_, keeping_.remembered_bytes);
  });
  return *handovers_;
}

std::unique_ptr<const Retessellation> CellWeigher::retessellation(const NormalMonth& month) const {
  const Handovers& all = handovers();
  return std::make_unique<const CellRetessellation>(all, *remembered_, month,
                                                    keeping_.counts_gauges);
}

}  // namespace thiessen
