// The fuzzer's short form, without libFuzzer; and each file of each sample cut off at every length,
// of which as many are tried as there are rounds. THIESSEN_ROUNDS=0 tries all.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "fuzzers/fuzzers.h"
#include "fuzzers/random_inputs.h"
#include "fuzzers/whole_runs.h"

namespace thiessen::fuzzers {
namespace {

using namespace std::literals;

/// Whether a file is one of lines, of which those that are there are whole. Of others nothing is
/// read in part.
bool has_lines(const std::string& name) {
  for (const std::string_view end : {".csv", ".CSV", ".txt", ".dly", ".pcp", ".cli", ".toml"}) {
    if (name.ends_with(end)) return true;
  }
  return false;
}

/// What is wrong with the answer to a file that is cut off; empty where it is right: an error, or
/// the answer to the whole file, or of lines that to those which are whole, or it is said.
std::string fault_of_cut(const Sample& sample, const std::string& name, std::size_t length,
                         const WholeRun& whole) {
  const auto answer_to = [&](std::size_t bytes) {
    auto files = sample.files;
    files[name].resize(bytes);
    return RunFolder::the_one().run(sample, files);
  };
  const WholeRun ran = answer_to(length);
  const bool is_fault = ran.told.find("a fault of the program itself") != std::string::npos;
  if (ran.status < 0 || ran.status > worst_status(sample) || is_fault)
    return "ends with " + std::to_string(ran.status) + ": " + ran.told;
  if (ran.status != 0 || ran.out == whole.out) return {};
  if (has_lines(name)) {
    const std::string text = sample.files.at(name).substr(0, length);
    const auto says = [&](std::string_view words) {
      return ran.told.find(words) != std::string::npos;
    };
    if (text.ends_with('\n') || says("cut off") || says("is passed over")) return {};
    if (ran.out == answer_to(text.rfind('\n') + 1).out) return {};
  }
  return "is answered in silence: " + ran.out + ran.told;
}

void expect_no_fault_of_cut(const Sample& sample, const std::string& name, std::size_t length,
                            const WholeRun& whole) {
  const std::string fault = fault_of_cut(sample, name, length, whole);
  if (!fault.empty())
    ADD_FAILURE() << sample.name << ": " << name << " cut at " << length << " of "
                  << sample.files.at(name).size() << " " << fault;
}

TEST(ProgramFuzzer, a_file_that_is_cut_off_is_an_error_or_gives_what_was_whole) {
  const char* const rounds = std::getenv("THIESSEN_ROUNDS");
  const bool all = rounds != nullptr && std::string_view(rounds) == "0";
  Seeded seeded;
  for (const Sample& sample : samples()) {
    const WholeRun whole = RunFolder::the_one().run(sample, sample.files);
    ASSERT_EQ(whole.status, 0) << sample.name << whole.told;
    for (const std::string& name : sample.read) {
      const std::size_t size = sample.files.at(name).size();
      if (all) {
        for (std::size_t length = 0; length < size; ++length)
          expect_no_fault_of_cut(sample, name, length, whole);
      } else {
        for (std::uint64_t round = 0; round < seeded.rounds(4); ++round)
          expect_no_fault_of_cut(sample, name, seeded.below(size), whole);
      }
    }
  }
}

TEST(ProgramFuzzer, finds_nothing_in_damaged_files) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(200); ++round) {
    const std::size_t number = seeded.below(samples().size());
    const Sample& sample = samples()[number];
    const std::size_t file = seeded.below(sample.read.size());
    const std::string text = damaged(seeded, sample.files.at(sample.read[file]), 4);
    expect_no_complaint(fuzz_program, input_of({4, number, file}, text));
    if (HasFailure()) return;
  }
}

TEST(ProgramFuzzer, finds_nothing_in_the_texts_of_options) {
  constexpr std::array texts = {"EPSG:32633"sv,
                                "+proj=utm +zone=32 +datum=WGS84"sv,
                                "id LIKE 'A%' AND lon > 10.5"sv,
                                "%d/%m/%Y %H:%M"sv,
                                "2020-01"sv,
                                "GEOGCS[\"WGS 84\",DATUM[\"x\"]]"sv,
                                "-9,NA"sv,
                                "month"sv,
                                "10.5,50.5"sv,
                                "natural"sv,
                                "1h,3h,1d"sv,
                                "auto"sv,
                                "\xc3\xa9"sv};
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(150); ++round) {
    const std::string text = damaged(seeded, std::string(texts[seeded.below(texts.size())]), 3);
    expect_no_complaint(fuzz_program,
                        input_of({1, seeded.below(2), seeded.below(16), seeded.below(16)}, text));
    if (HasFailure()) return;
  }
}

TEST(ProgramFuzzer, finds_nothing_in_the_names_that_are_written) {
  constexpr std::array names = {
      "A\xFE"
      "B\xFE"
      "east\xFE"
      "A title"sv,
      "</script>\xFE=1+1\xFE../x\xFE\xe2\x80\xae!"sv,
      "\xd8\xa7\xd9\x84\xFE\xe9\x9b\xa8\xFE\xe0\xb8\x97\xFE\x1b[2J"sv,
      "a\"b\xFE'\xFE\n\xFE\xf0\x9f\x8c\xa7"sv};
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(100); ++round) {
    const std::string text = damaged(seeded, std::string(names[round % names.size()]), 3);
    expect_no_complaint(fuzz_program, input_of({0, seeded.below(15)}, text));
    if (HasFailure()) return;
  }
}

TEST(ProgramFuzzer, finds_nothing_in_random_bytes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(100); ++round) {
    expect_no_complaint(fuzz_program, any_bytes(seeded, 100));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
