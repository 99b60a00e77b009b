#pragma once

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

namespace thiessen {

/// What makes a randomised test repeatable, and long where one wants it. Its failures say how to
/// run it again: THIESSEN_SEED picks the numbers (default 1), THIESSEN_ROUNDS multiplies the rounds
/// (default 1).
class Seeded {
 public:
  Seeded()
      : seed_(setting("THIESSEN_SEED", 1)), random_(seed_), trace_(__FILE__, __LINE__, rerun()) {}

  /// A test's usual number of rounds, times THIESSEN_ROUNDS.
  static std::uint64_t rounds(std::uint64_t usual) { return usual * setting("THIESSEN_ROUNDS", 1); }

  std::mt19937_64& generator() { return random_; }
  std::uint64_t below(std::uint64_t end) { return random_() % end; }
  std::int64_t whole(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }
  /// In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
  }
  /// The value, up to `ulps` doubles away.
  double near(double value, int ulps) {
    for (std::int64_t steps = whole(-ulps, ulps); steps != 0; steps += steps > 0 ? -1 : 1) {
      value = std::nextafter(value, steps > 0 ? HUGE_VAL : -HUGE_VAL);
    }
    return value;
  }

 private:
  static std::uint64_t setting(const char* name, std::uint64_t usual) {
    const char* text = std::getenv(name);
    if (text == nullptr) return usual;
    const std::string_view digits(text);
    std::uint64_t value = usual;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
  }
  std::string rerun() const {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    return "again: THIESSEN_SEED=" + std::to_string(seed_) +
           " THIESSEN_ROUNDS=" + std::to_string(rounds(1)) +
           " ... --gtest_filter=" + test->test_suite_name() + "." + test->name();
  }

  std::uint64_t seed_;
  std::mt19937_64 random_;
  testing::ScopedTrace trace_;
};

}  // namespace thiessen
