// The fuzzer's short form: hundreds of random inputs, without libFuzzer.
#include <gtest/gtest.h>

#include <cstdint>

#include "fuzzers/fuzzers.h"
#include "fuzzers/random_inputs.h"

namespace thiessen::fuzzers {
namespace {

TEST(StudyFuzzer, finds_nothing_in_random_studies) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1000); ++round) {
    expect_no_complaint(fuzz_study, any_bytes(seeded, 120));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
