#include "rainfall/methods/method_rainfall.h"

#include <utility>

namespace thiessen {
namespace {

template <typename Value, typename Of>
std::vector<Value> interleaved(const std::vector<std::unique_ptr<const StepRainfall>>& methods,
                               const Of& of) {
  std::vector<std::vector<Value>> all;
  all.reserve(methods.size());
  for (const auto& method : methods) all.push_back(of(*method));
  std::vector<Value> series;
  series.reserve(methods.size() * all.front().size());
  for (std::size_t b = 0; b < all.front().size(); ++b) {
    for (auto& values : all) series.push_back(std::move(values[b]));
  }
  return series;
}

}  // namespace

std::vector<BasinRainfall> SeveralMethods::at(std::span<const double> readings) const {
  return interleaved<BasinRainfall>(
      methods_, [&](const StepRainfall& method) { return method.at(readings); });
}

std::vector<BasinWeights> SeveralMethods::weights_at(std::span<const double> readings) const {
  return interleaved<BasinWeights>(
      methods_, [&](const StepRainfall& method) { return method.weights_at(readings); });
}

}  // namespace thiessen
