// The fuzzer's short form: some thousands of random inputs, without libFuzzer.
#include <gtest/gtest.h>

#include <cstdint>

#include "fuzzers/fuzzers.h"
#include "fuzzers/random_inputs.h"

namespace thiessen::fuzzers {
namespace {

TEST(OperationsFuzzer, finds_nothing_in_random_bytes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2000); ++round) {
    expect_no_complaint(fuzz_operations, any_bytes(seeded, 250));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
