#include "earth/sphere/latitude_series.h"

#include <GeographicLib/Constants.hpp>

namespace thiessen {
namespace {

double third_flattening() {
  const double f = GeographicLib::Constants::WGS84_f();
  return f / (2 - f);
}

}  // namespace

LatitudeSeries::LatitudeSeries(std::initializer_list<std::initializer_list<double>> terms) {
  const double n = third_flattening();
  std::size_t k = 0;
  for (const auto& polynomial : terms) {
    double factor = std::pow(n, static_cast<double>(k + 1));
    for (const double coefficient : polynomial) {
      terms_[k] += coefficient * factor;
      factor *= n;
    }
    ++k;
  }
}

const LatitudeSeries& latitude_series() {
  static const LatitudeSeries series{{2, -2. / 3, -2, 116. / 45, 26. / 45, -2854. / 675},
                                     {7. / 3, -8. / 5, -227. / 45, 2704. / 315, 2323. / 945},
                                     {56. / 15, -136. / 35, -1262. / 105, 73814. / 2835},
                                     {4279. / 630, -332. / 35, -399572. / 14175},
                                     {4174. / 315, -144838. / 6237},
                                     {601676. / 22275}};
  return series;
}

const LatitudeSeries& conformal_series() {
  static const LatitudeSeries series{{-2, 2. / 3, 4. / 3, -82. / 45, 32. / 45, 4642. / 4725},
                                     {5. / 3, -16. / 15, -13. / 9, 904. / 315, -1522. / 945},
                                     {-26. / 15, 34. / 21, 8. / 5, -12686. / 2835},
                                     {1237. / 630, -12. / 5, -24832. / 14175},
                                     {-734. / 315, 109598. / 31185},
                                     {444337. / 155925}};
  return series;
}

}  // namespace thiessen
