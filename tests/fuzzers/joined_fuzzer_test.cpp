// The fuzzer's short form: hundreds of random inputs, without libFuzzer.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzzers/fuzzers.h"
#include "fuzzers/random_inputs.h"

namespace thiessen::fuzzers {
namespace {

using namespace std::literals;

constexpr std::array sound = {
    "time,A,B\n2020-01-01,1,2\n2020-01-02,,3\n\xFEtime,B,07\n2020-01-02,3,4\n2020-01-03,5,6\n"sv,
    "time,station,rain\n2020-01-01T06:00,A,1\n2020-01-01T07:00,B,2\n\xFE"
    "date;time;A\n01/13/2020;06:00;1\n"sv,
    "time,A\n2020-01-01,1\n\xFEtime,A\n2020-01-01,2\n"sv};

TEST(JoinedFuzzer, finds_nothing_in_damaged_files) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(300); ++round) {
    const std::string text = damaged(seeded, std::string(sound[round % sound.size()]), 3);
    expect_no_complaint(fuzz_joined, input_of({1, round, round / 3, round / 7}, text));
    if (HasFailure()) return;
  }
}

TEST(JoinedFuzzer, finds_nothing_in_random_bytes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(600); ++round) {
    expect_no_complaint(fuzz_joined, any_bytes(seeded, 300));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
