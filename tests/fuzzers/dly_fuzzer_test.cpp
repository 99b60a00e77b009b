// The fuzzer's short form: hundreds of random inputs, without libFuzzer.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fuzzers/fuzzers.h"
#include "fuzzers/random_inputs.h"
#include "readings/dly_text.h"

namespace thiessen::fuzzers {
namespace {

/// Lines of rain and of other elements, as NOAA writes them, for two stations and a stranger.
std::string any_records(Seeded& seeded) {
  const std::vector<std::string> ids = {"USC00050848", "B          ", "C 1        ", "USC00000000"};
  std::string text;
  for (std::uint64_t count = 1 + seeded.below(4); count > 0; --count) {
    std::map<int, DlyColumns> days;
    for (std::uint64_t values = seeded.below(5); values > 0; --values)
      days[static_cast<int>(1 + seeded.below(29))] = {std::to_string(seeded.below(3000)),
                                                      seeded.below(4) == 0 ? " G0" : "  0"};
    text +=
        dly_line(ids[seeded.below(seeded.below(10) == 0 ? 4 : 3)],
                 static_cast<int>(2000 + seeded.below(3)), static_cast<int>(1 + seeded.below(12)),
                 days, seeded.below(6) == 0 ? "TMIN" : "PRCP") +
        (seeded.below(8) == 0 ? "\r\n" : "\n");
  }
  return text;
}

TEST(DlyFuzzer, finds_nothing_in_random_files) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(400); ++round) {
    const std::string text = damaged(seeded, any_records(seeded), 2);
    expect_no_complaint(fuzz_dly, input_of({1, seeded.below(2), seeded.below(2)}, text));
    if (HasFailure()) return;
  }
}

TEST(DlyFuzzer, finds_nothing_in_random_records) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(60); ++round) {
    std::vector<std::uint8_t> bytes = any_bytes(seeded, 400);
    bytes.insert(bytes.begin(), 0);
    expect_no_complaint(fuzz_dly, bytes);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
