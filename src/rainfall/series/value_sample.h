#pragma once

#include <cstddef>
#include <vector>

namespace thiessen {

/// An even sample of values that come one after the other, of which there may be any number: each
/// n-th, and the least and the largest in any case. NaN is no value. The same values in the same
/// order give the same sample. Memory: 32,768 values at most.
class ValueSample {
 public:
  void add(double value);
  /// The values that are kept, in their order; then the least and the largest of all.
  std::vector<double> values() const;

 private:
  std::vector<double> kept_;
  std::size_t each_ = 1;  ///< of so many values one is kept
  std::size_t seen_ = 0;
  double least_ = 0;
  double largest_ = 0;
};

}  // namespace thiessen
