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

constexpr std::array words = {"a"sv,
                              "Station"sv,
                              "id"sv,
                              "lon"sv,
                              "\n"sv,
                              "\n"sv,
                              " "sv,
                              "\t"sv,
                              "\x1b[2J"sv,
                              "'"sv,
                              "\xC3\xBC"sv,
                              "\xE4\xB8\x96"sv,
                              "\xF0\x9F\x98\x80"sv,
                              "\xD7\x90\xD7\x91"sv,
                              "\xD9\xA1"sv,
                              "12"sv,
                              "-0"sv,
                              "1.5"sv,
                              "007"sv,
                              "\xE2\x80\xAE"sv,
                              "\xE2\x80\xA8"sv,
                              "\xEF\xBB\xBF"sv,
                              "\xEF\xBF\xBD"sv,
                              "\xED\xA0\x80"sv,
                              "\xC0\xAF"sv,
                              "\xF4\x90\x80\x80"sv,
                              "\xCC\x81"sv,
                              "(x)"sv,
                              "/"sv,
                              "/dev/fd/"sv,
                              "/proc/self/fd/"sv,
                              "/dev/stdin"sv,
                              "9"sv,
                              "password"sv,
                              "="sv,
                              "://"sv,
                              "@"sv,
                              ":"sv,
                              "SECRET"sv,
                              "<html"sv,
                              "%PDF-"sv};

TEST(TextsFuzzer, finds_nothing_in_random_texts) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(6000); ++round) {
    std::string text = any_words(seeded, words, 20);
    if (seeded.below(3) == 0) text = damaged(seeded, text, 2);
    expect_no_complaint(fuzz_texts, input_of({round % 7}, text));
    if (HasFailure()) return;
  }
}

TEST(TextsFuzzer, finds_nothing_in_random_bytes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2000); ++round) {
    expect_no_complaint(fuzz_texts, any_bytes(seeded, 100));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
