#include "cli/options/arguments.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "cli/options/option_values.h"

namespace thiessen::cli {
namespace {

using Words = std::vector<std::string>;

/// Of a list with a flag, -q or --quiet, and an option with a value, -o or --output.
Arguments parse(const Words& arguments) {
  OptionList options;
  std::string output;
  options.group("All").add("-q,--quiet", sign(), "");
  options.group("All").add("-o,--output", any_text(output, "FILE"), "");
  return parse_arguments(arguments, {&options});
}

Words texts_of(const Arguments& sorted, const std::string& name) {
  for (const Arguments::Given& given : sorted.options) {
    if (given.name == name) return given.texts;
  }
  return {};
}

TEST(Arguments, ValuesFollowInFourWays) {
  for (const Words& line : {Words{"--output", "x"}, {"--output=x"}, {"-o", "x"}, {"-ox"}})
    EXPECT_EQ(texts_of(parse(line), "--output"), Words{"x"});
}

TEST(Arguments, AValueThatMayBeLeftOutIsFilledIn) {
  const auto value_of = [](const Words& arguments) {
    OptionList options;
    std::string file;
    OptionValue value = any_text(file, "[FILE]");
    value.when_left_out = "none";
    options.group("All").add("--file", std::move(value), "");
    options.group("All").add("-q,--quiet", sign(), "");
    return texts_of(parse_arguments(arguments, {&options}), "--file");
  };
  EXPECT_EQ(value_of({"a", "--file"}), Words{"none"});
  EXPECT_EQ(value_of({"--file", "-q", "a"}), Words{"none"});
  EXPECT_EQ(value_of({"--file", "--", "a"}), Words{"none"});
  EXPECT_EQ(value_of({"--file", "x", "a"}), Words{"x"});
  EXPECT_EQ(value_of({"--file=x", "a"}), Words{"x"});
  EXPECT_EQ(value_of({"--file", "-"}), Words{"-"});
  EXPECT_EQ(value_of({"--", "--file"}), Words{});
}

TEST(Arguments, LettersMayStandTogether) {
  const Arguments sorted = parse({"-qo", "x"});
  EXPECT_EQ(texts_of(sorted, "--output"), Words{"x"});
  EXPECT_EQ(texts_of(sorted, "--quiet"), Words{"true"});
}

TEST(Arguments, WordsKeepTheirOrder) {
  EXPECT_EQ(parse({"a", "-q", "b", "-o", "x", "c"}).words, (Words{"a", "b", "c"}));
  EXPECT_EQ(parse({"", "-"}).words, (Words{"", "-"}));
}

TEST(Arguments, AllAfterTwoDashesAreWords) {
  const Arguments sorted = parse({"a", "--", "-q", "--", "--none"});
  EXPECT_EQ(sorted.words, (Words{"a", "-q", "--", "--none"}));
  EXPECT_TRUE(sorted.unknown.empty());
}

TEST(Arguments, AValueMayLookLikeAnOption) {
  EXPECT_EQ(texts_of(parse({"-o", "-1"}), "--output"), Words{"-1"});
  EXPECT_EQ(texts_of(parse({"-o", "--quiet"}), "--output"), Words{"--quiet"});
  EXPECT_EQ(texts_of(parse({"-o", "[a,b]"}), "--output"), Words{"[a,b]"});
  EXPECT_EQ(texts_of(parse({"-o", ""}), "--output"), Words{""});
}

TEST(Arguments, EveryTimeCounts) {
  EXPECT_EQ(texts_of(parse({"-o", "x", "--output=y"}), "--output"), (Words{"x", "y"}));
}

TEST(Arguments, UnknownOptionsAreToldApart) {
  EXPECT_EQ(parse({"--none=5", "-x", "a", "-5"}).unknown, (Words{"--none", "-x", "-5"}));
  EXPECT_EQ(parse({"--out", "x"}).unknown, Words{"--out"});
}

TEST(Arguments, AValueMayBeMissingAtTheEnd) {
  const Arguments sorted = parse({"--none", "a", "-o"});
  EXPECT_EQ(sorted.incomplete, "--output");
  EXPECT_EQ(sorted.unknown, Words{"--none"});
  EXPECT_EQ(sorted.words, Words{"a"});
  EXPECT_EQ(parse({"-o", "x"}).incomplete, std::nullopt);
}

TEST(Arguments, AnOptionIsSpelledAsItWasWritten) {
  EXPECT_EQ(parse({"-o", "x"}).options.front().spelling, "-o");
  EXPECT_EQ(parse({"--output=x"}).options.front().spelling, "--output");
}

}  // namespace
}  // namespace thiessen::cli
