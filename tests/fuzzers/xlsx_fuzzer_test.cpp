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

constexpr std::string_view sound_of_ods =
    "\xFE<table:table-row table:number-rows-repeated=\"2\"/><table:table-row><table:table-cell "
    "office:value-type=\"string\"><text:p>time</text:p></table:table-cell><table:table-cell "
    "office:value-type=\"string\"><text:p>a</text:p></table:table-cell></table:table-row>"
    "<table:table-row table:number-rows-repeated=\"3\"><table:table-cell "
    "office:value-type=\"date\" office:date-value=\"2020-01-01T06:00:00\"/><table:table-cell "
    "table:number-columns-repeated=\"1\" office:value-type=\"float\" office:value=\"1.5\"/>"
    "</table:table-row>";

TEST(XlsxFuzzer, finds_nothing_in_damaged_sheets) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(300); ++round) {
    const std::string text = damaged(seeded, std::string(sound[round % sound.size()]), 4);
    expect_no_complaint(fuzz_xlsx, input_of({1, 1, 0}, text));
    expect_no_complaint(fuzz_xlsx, input_of({1, 0, round % 4, 0}, text));
    const std::string of_ods = damaged(seeded, std::string(sound_of_ods), 4);
    expect_no_complaint(fuzz_xlsx, input_of({1, 1, 1}, of_ods));
    expect_no_complaint(fuzz_xlsx, input_of({1, 0, round % 4, 1}, of_ods));
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
