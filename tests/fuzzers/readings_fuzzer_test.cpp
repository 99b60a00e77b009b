// The fuzzer's short form: hundreds of random inputs, without libFuzzer.
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

constexpr std::array words = {
    "time"sv, "station"sv, "rain_mm"sv, "A"sv, "B"sv,   "C 1"sv, "7"sv,   ","sv,    ","sv,  ","sv,
    "\n"sv,   "\n"sv,      "\r\n"sv,    "1"sv, "0.5"sv, "NA"sv,  "-1"sv,  ";"sv,    "\""sv, "1,5"sv,
    " "sv,    "2020"sv,    "2021"sv,    "9"sv, "10"sv,  "x"sv,   "1e9"sv, "-99.9"sv};

constexpr std::array sound = {
    "time,A,B,C 1\n2020-01-01,1,0.5,NA\n2020-01-02,,3,-999\n2020-01-03,1e1,\" 2\",0\n"sv,
    "time,station,rain_mm\n1,A,1\n1,B,2\n2,A,NA\n2,7,0.5\n3,C 1,4\n"sv,
    "date,station,value\n3,A,1\n1,B,2\n2,A,0\n3,7,0.5\n1,C 1,4\n2,Z,1\n"sv,
    "t,7,A\n9,1,2\n10,3,4\n8,5,6\n"sv, "t;A;s;v\n1;x;A;1,5\n2;y;B;x\n1;z;B;\n"sv};

TEST(ReadingsFuzzer, finds_nothing_in_random_tables) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(300); ++round) {
    const std::string text = round % 3 == 0
                                 ? "time,station,rain\n" + any_words(seeded, words, 60)
                                 : damaged(seeded, std::string(sound[round % sound.size()]), 3);
    expect_no_complaint(fuzz_readings, input_of({1, seeded.below(256), seeded.below(9)}, text));
    if (HasFailure()) return;
  }
}

TEST(ReadingsFuzzer, finds_nothing_in_random_readings) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(100); ++round) {
    std::vector<std::uint8_t> bytes = any_bytes(seeded, 300);
    bytes.insert(bytes.begin(), 0);
    expect_no_complaint(fuzz_readings, bytes);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
