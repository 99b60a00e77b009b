#include "map/sheet/ticks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace thiessen {
namespace {

constexpr std::array<long long, 3> mantissas{1, 2, 5};

double power_of_ten(long long digits, int exponent) {
  return RoundValue{digits, exponent}.value();
}

/// The multiples of a step, from the last at or below `least` to the first at or above `largest`.
struct Steps {
  long long first;
  long long last;
};

Steps steps(double least, double largest, RoundValue step) {
  const auto multiple = [&](long long k) { return power_of_ten(k * step.digits, step.exponent); };
  Steps s{static_cast<long long>(std::floor(least / step.value())),
          static_cast<long long>(std::ceil(largest / step.value()))};
  if (multiple(s.first + 1) <= least) ++s.first;
  if (multiple(s.last - 1) >= largest) --s.last;
  return s;
}

}  // namespace

double RoundValue::value() const {
  const std::string text = std::to_string(digits) + "e" + std::to_string(exponent);
  double result = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), result);
  if (read.ec == std::errc{}) return result;
  return exponent < 0 ? 0 : std::copysign(HUGE_VAL, static_cast<double>(digits));
}

std::string RoundValue::text() const {
  return decimal_text(digits, exponent);
}

std::string decimal_text(long long digits, int exponent) {
  if (digits == 0) return "0";
  for (; digits % 10 == 0; digits /= 10) ++exponent;
  std::string text = std::to_string(std::abs(digits));
  const std::string sign = digits < 0 ? "-" : "";
  const int length = static_cast<int>(text.size());
  if (exponent > 9 - length || exponent < -9) {
    const std::string power = std::to_string(exponent + length - 1);
    if (length > 1) text.insert(1, ".");
    return sign + text + "e" + power;
  }
  if (exponent >= 0) return sign + text + std::string(static_cast<std::size_t>(exponent), '0');
  if (-exponent >= length) text.insert(0, static_cast<std::size_t>(1 - exponent - length), '0');
  text.insert(text.size() - static_cast<std::size_t>(-exponent), ".");
  return sign + text;
}

std::vector<std::string> texts_of(const std::vector<RoundValue>& values) {
  std::vector<std::string> texts;
  std::size_t decimals = 0;
  const auto decimals_of = [](const std::string& text) {
    const std::size_t point = text.find('.');
    return point == std::string::npos ? 0 : text.size() - point - 1;
  };
  for (const RoundValue& value : values) {
    texts.push_back(value.text());
    if (texts.back().find('e') != std::string::npos) decimals = std::string::npos;
    if (decimals != std::string::npos) decimals = std::max(decimals, decimals_of(texts.back()));
  }
  if (decimals == std::string::npos) {
    for (std::size_t i = 0; i < values.size(); ++i) texts[i] = values[i].text();
    return texts;
  }
  for (std::string& text : texts) {
    const std::size_t lacking = decimals - decimals_of(text);
    if (lacking == decimals && decimals > 0) text += '.';
    text.append(lacking, '0');
  }
  return texts;
}

RoundValue nine_digits(double value) {
  if (value == 0) return {};
  int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)))) - 8;
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::scientific, 8);
  std::string plain(text.data(), end.ptr);
  const std::size_t mark = plain.find('e');
  const char* power = plain.data() + mark + (plain[mark + 1] == '+' ? 2 : 1);
  std::from_chars(power, plain.data() + plain.size(), exponent);
  std::string significand = plain.substr(0, mark);
  std::erase(significand, '.');
  long long digits = 0;
  std::from_chars(significand.data(), significand.data() + significand.size(), digits);
  exponent -= 8;
  for (; digits % 10 == 0; digits /= 10) ++exponent;
  return {digits, exponent};
}

RoundValue few_digits(double value) {
  constexpr int decimals = 2;
  constexpr int significant = 3;
  if (value == 0) return {};
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  const int last = std::min(-decimals, exponent - significant + 1);
  const double digits = value / power_of_ten(1, last);
  constexpr double most_digits = 1e15;  // beyond which a double has no decimals to be rounded
  if (!(std::abs(digits) < most_digits)) return nine_digits(value);
  return {std::llround(digits), last};
}

RoundValue round_down(double value, int digits) {
  if (value == 0) return {};
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)))) - digits + 1;
  RoundValue rounded{static_cast<long long>(std::floor(value / power_of_ten(1, exponent))),
                     exponent};
  // The quotient is rounded, so it may be one off.
  while (rounded.value() > value) --rounded.digits;
  while (power_of_ten(rounded.digits + 1, exponent) <= value) ++rounded.digits;
  return rounded;
}

RoundValue round_up(double value, int digits) {
  const RoundValue below = round_down(-value, digits);
  return {-below.digits, below.exponent};
}

RoundValue roundest(double low, double wanted, double high) {
  constexpr int finest = 9;
  const double largest = std::max(std::abs(low), std::abs(high));
  if (largest == 0) return {};
  const int exponent = static_cast<int>(std::floor(std::log10(largest)));
  for (int power = exponent; power > exponent - finest; --power) {
    for (const long long mantissa : {10LL, 5LL, 2LL}) {
      const RoundValue step{mantissa, power - 1};
      const auto multiple = static_cast<long long>(std::llround(wanted / step.value()));
      for (const long long k : {multiple, multiple - 1, multiple + 1}) {
        const RoundValue value{k * mantissa, power - 1};
        if (value.value() >= low && value.value() <= high) return value;
      }
    }
  }
  return nine_digits(wanted);
}

RoundValue round_below(double limit) {
  const int exponent = static_cast<int>(std::floor(std::log10(limit)));
  RoundValue best{1, exponent - 1};
  for (int power = exponent - 1; power <= exponent + 1; ++power) {
    for (const long long mantissa : mantissas) {
      if (power_of_ten(mantissa, power) <= limit) best = {mantissa, power};
    }
  }
  return best;
}

std::vector<RoundValue> round_scale(double least, double largest, int classes) {
  constexpr double narrowest = 1e-9;
  const double size = std::max(std::abs(least), std::abs(largest));
  const double range =
      largest / 2 - least / 2;  // half the range: the whole difference might overflow
  if (range <= size * narrowest || range < 1e-290) return {nine_digits(largest)};
  std::vector<RoundValue> ticks;
  const int exponent = static_cast<int>(std::floor(std::log10(range / classes))) - 1;
  for (int power = exponent; ticks.empty(); ++power) {
    for (const long long mantissa : mantissas) {
      const Steps s = steps(least, largest, {mantissa, power});
      if (s.last - s.first > classes || !ticks.empty()) continue;
      for (long long k = s.first; k <= s.last; ++k) ticks.push_back({k * mantissa, power});
    }
  }
  return ticks;
}

}  // namespace thiessen
