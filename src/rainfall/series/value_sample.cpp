#include "rainfall/series/value_sample.h"

#include <algorithm>
#include <cmath>

namespace thiessen {

void ValueSample::add(double value) {
  constexpr std::size_t most = 32'768;
  if (std::isnan(value)) return;
  least_ = seen_ == 0 ? value : std::min(least_, value);
  largest_ = seen_ == 0 ? value : std::max(largest_, value);
  if (seen_++ % each_ != 0) return;
  if (kept_.size() == most) {
    // Every second one goes, and this one is the first after them.
    for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
    kept_.resize(most / 2);
    each_ *= 2;
  }
  kept_.push_back(value);
}

std::vector<double> ValueSample::values() const {
  std::vector<double> values = kept_;
  if (seen_ > 0) values.insert(values.end(), {least_, largest_});
  return values;
}

}  // namespace thiessen
