#pragma once

namespace thiessen {

/// A sum of doubles that is carried in two doubles, with an error of 2^-100 of its largest partial
/// sum, so that the order of the terms does not show in the result (T. J. Dekker, A floating-point
/// technique for extending the available precision, 1971).
class LongSum {
 public:
  void add(double term) {
    const double sum = high_ + term;
    const double term_part = sum - high_;
    const double error = (high_ - (sum - term_part)) + (term - term_part) + low_;
    high_ = sum + error;
    low_ = error - (high_ - sum);
  }
  double value() const { return high_ + low_; }

 private:
  double high_ = 0;
  double low_ = 0;
};

}  // namespace thiessen
