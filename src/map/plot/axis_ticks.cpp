#include "map/plot/axis_ticks.h"

#include <algorithm>
#include <cmath>

#include "base/number.h"
#include "map/sheet/ticks.h"

namespace thiessen {
namespace {

/// Writes a value plainly, or with an exponent where that is shorter than a long number.
std::string tick_text(const RoundValue& value) {
  const std::size_t short_text = value.exponent < 0 ? 7 : 9;
  std::string plain = value.text();
  if (plain.size() <= short_text || value.exponent == 0) return plain;
  std::string significand = std::to_string(value.digits);
  const std::size_t first = value.digits < 0 ? 1 : 0;
  const std::size_t last = significand.find_last_not_of('0');
  const auto power = value.exponent + static_cast<int>(significand.size() - first) - 1;
  significand.erase(last + 1);
  if (last > first) significand.insert(first + 1, ".");
  const std::string scientific = significand + "e" + std::to_string(power);
  return scientific.size() < plain.size() ? scientific : plain;
}

/// The texts of an axis, all with as many decimals unless one is better written with an exponent.
std::vector<std::string> tick_texts(const std::vector<RoundValue>& values) {
  std::vector<std::string> own;
  bool all_plain = true;
  for (const RoundValue& value : values) {
    own.push_back(tick_text(value));
    all_plain = all_plain && own.back() == value.text();
  }
  return all_plain ? texts_of(values) : own;
}

/// The round values from low to high, each less by `shift`.
std::vector<AxisTicks::Tick> ticks_between(double low, double high, int most, double shift) {
  std::vector<RoundValue> values = round_scale(low, high, most + 1);
  std::erase_if(values, [&](const RoundValue& v) { return v.value() < low || v.value() > high; });
  const std::vector<std::string> texts = tick_texts(values);
  std::vector<AxisTicks::Tick> ticks;
  for (std::size_t i = 0; i < values.size(); ++i)
    ticks.push_back({values[i].value() - shift, texts[i]});
  return ticks;
}

}  // namespace

std::string AxisTicks::title(char name) const {
  std::string text(1, name);
  if (base.empty()) return text;
  return base.front() == '-' ? text + " + " + base.substr(1) : text + " \u2212 " + base;
}

AxisTicks axis_ticks(double origin, double low, double high, int most) {
  constexpr double sixth_digit = 2e-5;
  constexpr double most_steps = 1e17;  // in the range; doubles cannot tell more steps apart
  const double largest = std::max(std::abs(origin + low), std::abs(origin + high));
  const double range = high - low;
  if (range > sixth_digit * largest) {
    return {ticks_between(origin + low, origin + high, most, origin), {}};
  }
  const int exponent = static_cast<int>(std::ceil(std::log10(range)));
  const double steps = origin / RoundValue{1, exponent}.value();
  if (!(std::abs(steps) < most_steps)) return {};
  const double base = RoundValue{std::llround(steps), exponent}.value();
  const double beyond = origin - base;
  return {ticks_between(beyond + low, beyond + high, most, beyond), shortest_text(base)};
}

}  // namespace thiessen
