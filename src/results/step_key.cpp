#include "results/step_key.h"

#include <functional>

#include "base/utf8.h"

namespace thiessen {

StepKey step_key(std::string_view time) {
  const ParsedTime parsed = parse_iso_time(trimmed(time));
  StepKey key;
  if (!parsed) {
    key.text = time;
    return key;
  }
  key.is_moment = true;
  key.has_zone = parsed.time.ahead_of_utc.has_value();
  key.precision = parsed.time.precision;
  key.seconds = moment_seconds(parsed.time);
  key.nanosecond = parsed.time.nanosecond;
  return key;
}

bool are_alike(const StepKey& a, const StepKey& b) {
  return a.is_moment == b.is_moment && a.has_zone == b.has_zone && a.precision == b.precision;
}

bool comes_before(const StepKey& a, const StepKey& b) {
  if (!a.is_moment || !b.is_moment) return false;
  return a.seconds != b.seconds ? a.seconds < b.seconds : a.nanosecond < b.nanosecond;
}

std::uint64_t hash_of(const StepKey& key) {
  if (!key.is_moment) return std::hash<std::string>()(key.text);
  const auto moment = static_cast<std::uint64_t>(key.seconds) * 1'000'003u +
                      static_cast<std::uint64_t>(key.nanosecond);
  return moment * 0x9E3779B97F4A7C15u;
}

}  // namespace thiessen
