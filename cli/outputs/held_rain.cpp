#include "cli/outputs/held_rain.h"

namespace thiessen::cli {

void HeldRain::add(const std::string& time, std::span<const double> values) {
  if (!rain_) return;
  if (rain_->values.size() + values.size() > most_values) {
    rain_.reset();
    return;
  }
  rain_->times.push_back(time);
  rain_->values.insert(rain_->values.end(), values.begin(), values.end());
}

}  // namespace thiessen::cli
