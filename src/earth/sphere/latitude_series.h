#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace thiessen {

/// A series in sines of multiples of one latitude that gives the difference between the geographic
/// and the conformal latitude, either way. It goes to the sixth power of the third flattening; the
/// terms left out are below 1e-18.
class LatitudeSeries {
 public:
  /// terms[k] are the coefficients of n^(k+1), n^(k+2) and so on in the factor of sin(2(k+1) x),
  /// where n is the third flattening.
  LatitudeSeries(std::initializer_list<std::initializer_list<double>> terms);

  /// The sum at the latitude whose sine and cosine are given, by Clenshaw's method.
  double at(double sine, double cosine) const {
    const double sine_of_double = 2 * sine * cosine;
    const double twice_cosine_of_double = 2 * (cosine - sine) * (cosine + sine);
    double before = 0;
    double sum = 0;
    for (std::size_t i = terms_.size(); i-- > 0;) {
      const double next = twice_cosine_of_double * sum - before + terms_[i];
      before = sum;
      sum = next;
    }
    return sine_of_double * sum;
  }
  /// The sum at middle + step / 2 minus the sum at middle - step / 2, without cancellation.
  double difference(double middle, double step) const {
    double sum = 0;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      const double multiple = 2 * static_cast<double>(i + 1);
      sum += 2 * terms_[i] * std::cos(multiple * middle) * std::sin(multiple * step / 2);
    }
    return sum;
  }

 private:
  std::array<double, 6> terms_{};
};

/// What the geographic latitude is more than the conformal one, by the conformal one.
const LatitudeSeries& latitude_series();
/// What the conformal latitude is more than the geographic one, by the geographic one.
const LatitudeSeries& conformal_series();

}  // namespace thiessen
