// The fuzzer's short form: some thousands of random inputs, without libFuzzer.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzzers/fuzzers.h"
#include "fuzzers/random_inputs.h"

namespace thiessen::fuzzers {
namespace {

/// Words that scripts, CSVs and GeoJSON are made of, in any order, and now and then any bytes.
std::vector<std::uint8_t> any_text(Seeded& seeded, std::size_t kind) {
  static const std::vector<std::string_view> of_scripts{
      "add ",  "delete ", "undo\n", "redo\n",  "nearest ", "cell ",  "load x\n", "print\n",
      "check", "help\n",  "quit",   "\n",      "\r\n",     " ",      "0",        "1 ",
      "2 ",    "0.5 ",    "-1 ",    "1e59 ",   "1e-40 ",   "3",      "#",        "'",
      "\"",    "\x1e",    "x,y\n",  "x,y,z\n", ",",        "nan",    "1e999",    "-0 ",
      "0 0\n", "1 0\n",   "0 1\n",  "1 1\n",   "1 1 1\n",  "0 0 1\n"};
  static const std::vector<std::string_view> of_tables{
      "x,y\n", "x,y,z\n", "\xEF\xBB\xBF", ",",  ";",  "\n", "\r",  "\"",  "\"\"", "1", "2.5",
      "-0",    "1e60",    "+5",           ".5", "5.", " ",  "nan", "lon", "lat",  "\t"};
  static const std::vector<std::string_view> of_geojson{
      "{",
      "}",
      "[",
      "]",
      ",",
      ":",
      "\"",
      "\"type\":",
      "\"Feature\"",
      "\"FeatureCollection\"",
      "\"features\":",
      "\"geometry\":",
      "\"coordinates\":",
      "\"Polygon\"",
      "\"Point\"",
      "\"crs\":",
      "\"properties\":",
      "null",
      "1",
      "-1.5e3",
      " ",
      "\\u0041",
      "{\"type\":\"Point\",\"coordinates\":[1,2]}",
      "true",
      "\"name\""};
  const auto& words = kind < 4 || kind == 7 ? of_scripts : kind < 6 ? of_tables : of_geojson;
  std::string text;
  const std::size_t count = seeded.below(80);
  for (std::size_t i = 0; i < count; ++i) {
    text += words[seeded.below(words.size())];
    if (seeded.below(200) == 0) text += static_cast<char>(seeded.below(256));
  }
  return {text.begin(), text.end()};
}

TEST(ScriptFuzzer, finds_nothing_in_random_texts) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(4000); ++round) {
    const std::size_t kind = round % 8;
    std::vector<std::uint8_t> bytes =
        round % 16 < 14 ? any_text(seeded, kind) : any_bytes(seeded, 300);
    bytes.insert(bytes.begin(), static_cast<std::uint8_t>(kind));
    expect_no_complaint(fuzz_script, bytes);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
