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
    "\xFE<row r=\"1\"><c r=\"A1\" t=\"s\"><v>0</v></c><c r=\"B1\"><v>7</v></c></row>"
    "<row r=\"2\"><c s=\"1\"><v>43831.25</v></c><c><v>1.5</v></c></row>"
    "<row r=\"5\"><c s=\"2\"><v>43832</v></c><c r=\"B5\" t=\"e\"><v>#N/A</v></c></row>"sv,
    "<workbookPr date1904=\"1\"/>\xFE<row r=\"1\"><c r=\"A1\" t=\"inlineStr\"><is><t>Rain of "
    "2020</t></is></c></row><row r=\"3\"><c r=\"A3\" t=\"s\"><v>0</v></c><c r=\"B3\" t=\"s\"><v>1"
    "</v></c></row><row r=\"4\"><c r=\"A4\" s=\"1\"><v>42369</v></c><c r=\"B4\"><f>1+1</f></c>"
    "</row>"sv};

TEST(XlsxFuzzer, finds_nothing_in_damaged_sheets) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(300); ++round) {
    const std::string text = damaged(seeded, std::string(sound[round % sound.size()]), 4);
    expect_no_complaint(fuzz_xlsx, input_of({1, round % 8, round % 5}, text));
    if (HasFailure()) return;
  }
}

TEST(XlsxFuzzer, finds_nothing_in_random_bytes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(300); ++round) {
    expect_no_complaint(fuzz_xlsx, any_bytes(seeded, 100));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
