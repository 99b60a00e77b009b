#include "readings/steps/given_steps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <tuple>

namespace thiessen {
namespace {

/// A number that tells readings from others: FNV-1a over their bits, all NaN alike.
std::uint64_t hash_of(std::span<const double> readings) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const double reading : readings) {
    constexpr std::uint64_t silent = 1;
    hash ^= std::isnan(reading) ? silent : std::bit_cast<std::uint64_t>(reading);
    hash *= 0x100000001B3U;
    hash ^= hash >> 29U;  // so that the low bits of the next product hear of the high ones
  }
  return hash;
}

}  // namespace

GivenSteps::Came GivenSteps::take(const TimeStep& step) {
  const std::uint64_t readings = hash_of(step.readings);
  const ParsedTime time = calendar_time(step.time, step.written);
  if (!time) return take_text(step.time, readings);
  return take_moment({moment_seconds(time.time), time.time.nanosecond, readings});
}

GivenSteps::Came GivenSteps::take_moment(const Moment& moment) {
  const auto place = [](const Moment& one) { return std::tuple(one.seconds, one.nanosecond); };
  if (ascending_.empty() || place(ascending_.back()) < place(moment)) {
    ascending_.push_back(moment);
    return Came::first;
  }
  const auto found = std::ranges::lower_bound(ascending_, place(moment), {}, place);
  if (place(*found) == place(moment))
    return found->readings == moment.readings ? Came::again : Came::again_otherwise;
  return take_text(std::to_string(moment.seconds) + "." + std::to_string(moment.nanosecond),
                   moment.readings);
}

GivenSteps::Came GivenSteps::take_text(const std::string& time, std::uint64_t readings) {
  const auto [known, fresh] = others_.try_emplace(time, readings);
  if (fresh) return Came::first;
  return known->second == readings ? Came::again : Came::again_otherwise;
}

}  // namespace thiessen
