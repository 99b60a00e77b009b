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
    "x,y\n"sv,    "x,y,z\n"sv, "\xEF\xBB\xBF"sv, ","sv,    ";"sv,   "\n"sv,
    "\r"sv,       "\r\n"sv,    "\""sv,           "\"\""sv, "1"sv,   "2.5"sv,
    "-0"sv,       "1e60"sv,    "+5"sv,           ".5"sv,   "5."sv,  " "sv,
    "nan"sv,      "lon"sv,     "lat"sv,          "\t"sv,   "|"sv,   "a"sv,
    "\xC3\xBC"sv, "#"sv,       "sep=;\n"sv,      "mm"sv,   "eor"sv, "5s\t"sv};

constexpr std::array sound = {"time,\"A \"\"1\"\"\",B\r\n\"x\ny\",1.5,\n2,,\"\xC3\xBC\"\n"sv,
                              "\xEF\xBB\xBFid;x;y\n\"a;b\";1,5;2\n\nc; 3 ;\"\"\"\"\n"sv,
                              "a|b|\n1|2|3\r4|\"5\r\n6\"|\r\n  \n7||8"sv,
                              "\"only\"\n\"1\"\n\"\xE4\xB8\x96\"\n\" \"\n"sv,
                              "name\tx\ty\tz\nA\t1e-3\t2\t-0\nB\t0\t0\t1\n"sv,
                              "x,y\n0,0\n1,0.5\n-3.25,1e59\n"sv,
                              "lon,lat,height\n-105.25,40.0125,1600\n-105,40,1500\n"sv,
                              "0,0,0\n1,0,0\n0,1,0\n0,0,1\n"sv,
                              "\xFF\xFEt\0i\0m\0e\0,\0A\0\n\0"sv};

TEST(CsvFuzzer, finds_nothing_in_random_tables) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(400); ++round) {
    const std::string text = round % 3 == 0
                                 ? any_words(seeded, words, 40)
                                 : damaged(seeded, std::string(sound[round % sound.size()]));
    const std::vector<std::uint8_t> bytes =
        input_of({seeded.below(16) == 0 ? seeded.below(2) : 2, seeded.below(8),
                  seeded.below(64) == 0 ? 16 + seeded.below(16) : seeded.below(16),
                  seeded.below(256), seeded.below(256), seeded.below(256), seeded.below(8)},
                 text);
    expect_no_complaint(fuzz_csv, bytes);
    if (HasFailure()) return;
  }
}

constexpr std::array forms = {"# r\nsep=;\nid;x;y;\n;mm;;\nA;1,5;2;\n;;;\nB;1,234;2;\n"sv,
                              "Title, of all\n\ndate,A,B,eor\n1,2.5,3,eor\n2,1,1,eor\n"sv,
                              "agency_cd\tsite_no\tp\n5s\t15s\t14n\nU\t1\t2\n"sv,
                              "# a \"b\n# id x y\nA 1  2\nB 3 4 \n"sv,
                              "\xFE\xFF\0i\0d\0;\0x\0\n\0A\0;\0001\0\n"sv};

TEST(CsvFuzzer, finds_nothing_in_tables_of_unknown_form) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(400); ++round) {
    const std::string text = round % 3 == 0
                                 ? any_words(seeded, words, 40)
                                 : damaged(seeded, std::string(forms[round % forms.size()]), 2);
    expect_no_complaint(fuzz_csv, input_of({4, seeded.below(8), seeded.below(8), seeded.below(8),
                                            seeded.below(8), seeded.below(8)},
                                           text));
    if (HasFailure()) return;
  }
}

TEST(CsvFuzzer, finds_nothing_in_random_points) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(400); ++round) {
    const std::string text = round % 3 == 0 ? any_words(seeded, words, 40)
                                            : damaged(seeded, std::string(sound[5 + round % 3]), 2);
    expect_no_complaint(fuzz_csv, input_of({seeded.below(2)}, text));
    if (HasFailure()) return;
  }
}

TEST(CsvFuzzer, finds_nothing_in_random_bytes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(100); ++round) {
    expect_no_complaint(fuzz_csv, any_bytes(seeded, 300));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
