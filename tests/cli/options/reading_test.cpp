#include "cli/options/reading.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {
namespace {

/// The command `paint SOURCE [TARGET] --width N [-q] [-o FILE]`.
struct Painting {
  Painting() {
    OptionGroup files = options.group("Files");
    files.add("SOURCE", file(source), "").need = Need::required;
    files.add("TARGET", file(target), "");
    OptionGroup rest = options.group("Rest");
    rest.add("--width", whole_number(width, 1, 9), "").need = Need::required;
    rest.add("-q,--quiet", flag(quiet), "");
    rest.add("-o,--output", file(output, "FILE"), "");
  }

  std::string refusal(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "paint");
    const Arguments said = parse_arguments(arguments, {&options});
    const std::string unknown = unknown_option(options, said);
    if (!unknown.empty()) return "unknown " + unknown;
    try {
      Warnings warnings;
      read_options(options, said, warnings);
    } catch (const UsageError& error) {
      return error.text;
    }
    return {};
  }

  OptionList options;
  std::string source, target, output;
  std::size_t width = 0;
  bool quiet = false;
};

TEST(Reading, GivesOptionsTheirValuesAndArgumentsTheWords) {
  Painting paint;
  EXPECT_EQ(paint.refusal({"a", "--width", "3", "b", "-q"}), "");
  EXPECT_EQ(paint.source, "a");
  EXPECT_EQ(paint.target, "b");
  EXPECT_EQ(paint.width, 3u);
  EXPECT_TRUE(paint.quiet);
  EXPECT_FALSE(paint.options.find("-o")->is_given());
}

TEST(Reading, TellsWhatDoesNotExistBeforeAllElse) {
  EXPECT_EQ(Painting().refusal({"--widht", "--width", "x"}), "unknown --widht");
  EXPECT_EQ(Painting().refusal({"--width", "x", "--nothing", "-o"}), "unknown --nothing");
}

TEST(Reading, TellsValuesBeforeWhatIsMissing) {
  EXPECT_EQ(Painting().refusal({"--width", "x"}),
            "--width wants a whole number from 1 to 9, not 'x'");
  EXPECT_EQ(Painting().refusal({"--width=1", "--width=2"}), "--width is given more than once");
  EXPECT_EQ(Painting().refusal({"--quiet=no"}), "--quiet takes no value");
  EXPECT_EQ(Painting().refusal({"-o"}), "-o needs a value: FILE");
}

TEST(Reading, TellsAllThatIsMissing) {
  EXPECT_EQ(Painting().refusal({}), "SOURCE and --width N are missing");
  EXPECT_EQ(Painting().refusal({"a"}), "--width N is missing");
}

TEST(Reading, TellsOfAWordTooMany) {
  EXPECT_EQ(Painting().refusal({"a", "b", "c", "d", "--width=1"}), "one file too many: 'c'");
}

TEST(Reading, ANameOfAFileIsNotEmpty) {
  Painting paint;
  EXPECT_EQ(paint.refusal({"a", "--width=1"}), "");
  EXPECT_NO_THROW(require_file_names(paint.options));
  Painting empty;
  EXPECT_EQ(empty.refusal({"", "--width=1"}), "");
  EXPECT_THROW(require_file_names(empty.options), Error);
}

}  // namespace
}  // namespace thiessen::cli
