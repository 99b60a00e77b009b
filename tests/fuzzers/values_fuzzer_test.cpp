// The fuzzer's short form: some thousands of random inputs, without libFuzzer.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzzers/fuzzers.h"
#include "fuzzers/random_inputs.h"

namespace thiessen::fuzzers {
namespace {

using namespace std::literals;

constexpr std::array words = {"0"sv,       "1"sv,
                              "9"sv,       "12"sv,
                              "007"sv,     "5."sv,
                              ".5"sv,      "+"sv,
                              "-"sv,       "e"sv,
                              "E-3"sv,     "e308"sv,
                              "e-320"sv,   ","sv,
                              "."sv,       "-999"sv,
                              "NA"sv,      " "sv,
                              "2020"sv,    "-02"sv,
                              "-29"sv,     "T06"sv,
                              ":00"sv,     "Z"sv,
                              "+05:30"sv,  "nan"sv,
                              "\n"sv,      "9e15"sv,
                              "inf"sv,     "0x1"sv,
                              "T24:00"sv,  "/"sv,
                              "null"sv,    "9007199254740993"sv,
                              "\xD9\xA1"sv};

constexpr std::array times = {"2013"sv,
                              "2013-08"sv,
                              "2013-08-31"sv,
                              "20130831"sv,
                              "2013-08-31T06:00"sv,
                              "20130831T0600"sv,
                              "2013-08-31 06:00:59.123456789"sv,
                              "2013-12-31T24:00:00Z"sv,
                              "2000-02-29T23:59:59,5-03:30"sv,
                              "0000-01-01T00+14"sv,
                              "9999-12-31T24:00-14"sv};

TEST(ValuesFuzzer, finds_nothing_in_random_numbers_and_fields) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(10000); ++round) {
    const std::uint64_t kind = round % 2 == 0 ? 0 : 6;
    const std::string text = any_words(seeded, words, 6);
    expect_no_complaint(fuzz_values,
                        kind == 0 ? input_of({0}, text) : input_of({6, seeded.below(2)}, text));
    if (HasFailure()) return;
  }
}

constexpr std::array written = {
    "31/12/2010 06:00"sv, "12/31/2010 6:00:00 PM"sv, "1.2.2010"sv,
    "2010123109"sv,       "31-Dec-2010 2400"sv,      "01JAN2000:13:00"sv,
    "Dec 31, 2010"sv,     "2010/12/31 0000 UTC"sv,   "20160101 00:00+01:30"sv};

TEST(ValuesFuzzer, finds_nothing_in_times_written_otherwise) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1000); ++round) {
    std::string text;
    for (int i = 0; i < 3; ++i)
      text += damaged(seeded, std::string(written[seeded.below(written.size())]), 2) + "\n";
    expect_no_complaint(fuzz_values, input_of({8}, text));
    if (HasFailure()) return;
  }
}

TEST(ValuesFuzzer, finds_nothing_in_random_doubles) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(10000); ++round) {
    std::string bits;
    for (int i = 0; i < 8; ++i) bits += static_cast<char>(seeded.below(256));
    expect_no_complaint(fuzz_values, input_of({2, seeded.below(101)}, bits));
    if (HasFailure()) return;
  }
}

TEST(ValuesFuzzer, finds_nothing_in_random_times) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(10000); ++round) {
    const auto any_time = [&] {
      return seeded.below(3) == 0
                 ? any_words(seeded, words, 8)
                 : damaged(seeded, std::string(times[seeded.below(times.size())]), 2);
    };
    if (round % 2 == 0) {
      expect_no_complaint(fuzz_values, input_of({3}, any_time()));
    } else {
      expect_no_complaint(fuzz_values,
                          input_of({5}, any_time() + "\n" + any_time() + "\n" + any_time()));
    }
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
