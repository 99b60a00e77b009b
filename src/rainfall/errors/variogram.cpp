#include "rainfall/errors/variogram.h"

#include <algorithm>
#include <cmath>

namespace thiessen {

double VariogramModel::rise(double distance) const {
  const double u = distance / range;
  if (shape == Shape::spherical) return u < 1 ? u * (1.5 - 0.5 * u * u) : 1;
  return -std::expm1(-std::pow(u, exponent));
}

Variogram::Variogram(const VariogramModel& model, double longest) : model_(model) {
  const std::size_t last = piece_of(longest * longest);
  constexpr std::size_t octaves = 40;
  constexpr std::size_t count = octaves << piece_bits;
  first_ = last - std::min(last, count);
  lowest_ = begin_of(first_);
  pieces_.reserve(last - first_ + 1);
  double value = model(std::sqrt(begin_of(first_)));
  for (std::size_t i = first_; i <= last; ++i) {
    const double next = model(std::sqrt(begin_of(i + 1)));
    pieces_.push_back({begin_of(i), value, (next - value) / (begin_of(i + 1) - begin_of(i))});
    value = next;
  }
}

double Variogram::beyond(double square) const {
  if (square > lowest_) return model_(std::sqrt(square));
  return model_.nugget + (pieces_.front().value - model_.nugget) * (square / lowest_);
}

}  // namespace thiessen
