#include "rainfall/gaps/strictness.h"

#include <limits>

namespace thiessen {

double Strictness::value(const Reporting& reporting) const {
  return reporting.complete ? reporting.sum : std::numeric_limits<double>::quiet_NaN();
}

BasinWeights Strictness::weights(const BasinWeights& full, std::span<const double> readings) const {
  return reporting(full, readings).complete ? full : BasinWeights{full.area, {}};
}

}  // namespace thiessen
