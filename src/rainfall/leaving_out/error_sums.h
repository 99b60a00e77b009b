#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

namespace thiessen {

/// The sums of what estimates are off by, estimate less truth.
struct ErrorSums {
  std::size_t count = 0;
  double errors = 0;
  double squares = 0;

  void add(double error) {
    ++count;
    errors += error;
    squares += error * error;
  }
  /// The mean error; NaN where there is none.
  double bias() const { return mean(errors); }
  double mean_square() const { return mean(squares); }
  double root_mean_square() const { return std::sqrt(mean_square()); }

 private:
  double mean(double sum) const {
    return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(count);
  }
};

}  // namespace thiessen
