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
    "add "sv,
    "delete "sv,
    "undo\n"sv,
    "redo\n"sv,
    "nearest "sv,
    "cell "sv,
    "load x\n"sv,
    "print\n"sv,
    "check"sv,
    "help\n"sv,
    "quit"sv,
    "\n"sv,
    "\r\n"sv,
    " "sv,
    "0"sv,
    "1 "sv,
    "2 "sv,
    "0.5 "sv,
    "-1 "sv,
    "1e59 "sv,
    "1e-40 "sv,
    "3"sv,
    "#"sv,
    "'"sv,
    "\""sv,
    "\x1e"sv,
    "x,y\n"sv,
    "x,y,z\n"sv,
    ","sv,
    "nan"sv,
    "1e999"sv,
    "-0 "sv,
    "0 0\n"sv,
    "1 0\n"sv,
    "0 1\n"sv,
    "1 1\n"sv,
    "1 1 1\n"sv,
    "0 0 1\n"sv,
    "show "sv,
    "a.png "sv,
    "--view "sv,
    "--site 1,2,3\n"sv,
    "point "sv,
    "vertex "sv,
    "\x1epoint 1 0 0\npoint 2 1 0\npoint 4 0 1\n"sv,
    "vertex 5 center 0.5 0.5 radius 0.7 forming 1 2 4 neighbors 0 0 0\n"sv};

TEST(ScriptFuzzer, finds_nothing_in_random_scripts) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(250); ++round) {
    expect_no_complaint(fuzz_script, input_of({round % 2}, any_words(seeded, words, 80)));
    if (HasFailure()) return;
  }
}

TEST(ScriptFuzzer, finds_nothing_in_random_bytes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(100); ++round) {
    expect_no_complaint(fuzz_script, any_bytes(seeded, 300));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
