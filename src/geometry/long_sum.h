#pragma once

#include "geometry/expansion.h"

namespace thiessen {

/// A sum of doubles carried in two of them, to 2^-100 of its largest partial sum, so that the order
/// of its terms does not show in the result (T. J. Dekker, A floating-point technique for extending
/// the available precision, 1971).
class LongSum {
 public:
  void add(double term) {
    const exact::Pair sum = exact::two_sum(high_, term);
    const exact::Pair carried = exact::fast_two_sum(sum.rounded, sum.error + low_);
    high_ = carried.rounded;
    low_ = carried.error;
  }
  double value() const { return high_ + low_; }

 private:
  double high_ = 0;
  double low_ = 0;
};

}  // namespace thiessen
