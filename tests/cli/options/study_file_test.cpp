#include "cli/options/study_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/temporary_folder.h"
#include "base/version.h"
#include "cli/options/option_values.h"
#include "cli/options/reading.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {
namespace {

/// The command `paint STATIONS RAINFALL` with some options, and a file for --config.
struct Painting {
  explicit Painting(const std::string& text) : path(folder.write("study.toml", text)) {
    OptionGroup files = options.group("Files");
    files.add("STATIONS", file(stations), "").need = Need::required;
    Option& argument = files.add("RAINFALL", file(rainfall), "");
    OptionValue repeated = texts(several, "FILE");
    repeated.completion = Completion::file;
    files.add("--missing", texts(missing, "V"), "");
    argument.instead = {&files.add("--rainfall", repeated, "")};
    OptionGroup rest = options.group("Rest");
    rest.add("--basin-id", any_text(basin_id, "FIELD"), "");
    rest.add("--width", whole_number(width, 1, 9), "");
    rest.add("--tolerance", number(tolerance, above_zero), "");
    rest.add("--mend", flag(mend), "");
    rest.add("-o,--output", file(output, "FILE"), "");
    rest.add(study_file_option, file(config, "FILE"), "");
  }

  /// What is said of the words after the command, with --config.
  std::string refusal(std::vector<std::string> words = {}) {
    words.insert(words.begin(), {"paint", "--config", path});
    const Arguments said = parse_arguments(words, {&options});
    try {
      read_options(options, said, warnings);
    } catch (const UsageError& error) {
      const std::string text = error.text + (error.hint.empty() ? "" : " | " + error.hint);
      const std::size_t at = text.find(path);
      return at == std::string::npos ? text : text.substr(0, at) + text.substr(at + path.size());
    }
    return {};
  }
  std::string written(const std::string& into) {
    const std::string text = study_file_text(options, "paint", into, warnings);
    return text.substr(text.rfind("folder.\n") + 8);
  }
  std::string in_folder(const std::string& name) const {
    return (std::filesystem::path(path).parent_path() / name).string();
  }

  TemporaryFolder folder;
  std::string path;
  OptionList options;
  Warnings warnings;
  std::string stations, rainfall, basin_id, output, config;
  std::vector<std::string> several, missing;
  std::size_t width = 0;
  double tolerance = 0;
  bool mend = false;
};

TEST(StudyFile, GivesArgumentsAndOptions) {
  Painting paint(
      "stations = 's.csv'\nbasin_id = 'name'\nwidth = 3\nmend = true\nmissing = ['x', -9]\n");
  EXPECT_EQ(paint.refusal(), "");
  EXPECT_EQ(paint.basin_id, "name");
  EXPECT_EQ(paint.width, 3u);
  EXPECT_TRUE(paint.mend);
  EXPECT_EQ(paint.missing, (std::vector<std::string>{"x", "-9"}));
  EXPECT_TRUE(paint.warnings.notices().empty());
}

TEST(StudyFile, CountsRelativeNamesOfFilesFromItsFolder) {
  Painting paint(
      "STATIONS = 'a/s.csv'\nrainfall = ['r.csv', '/all/r.csv', '-', 'PG:dbname=x']\n"
      "basin-id = 'a/b'\n");
  EXPECT_EQ(paint.refusal(), "");
  EXPECT_EQ(paint.stations, paint.in_folder("a/s.csv"));
  EXPECT_EQ(paint.several,
            (std::vector<std::string>{paint.in_folder("r.csv"), "/all/r.csv", "-", "PG:dbname=x"}));
  EXPECT_EQ(paint.basin_id, "a/b");
}

TEST(StudyFile, YieldsToTheCommandLineAndSaysSo) {
  Painting paint("stations = 's'\nrainfall = 'r'\nwidth = 3\nmissing = 'x'\n");
  EXPECT_EQ(paint.refusal({"t", "q", "--width", "4", "--missing", "y"}), "");
  EXPECT_EQ(paint.stations, "t");
  EXPECT_EQ(paint.rainfall, "q");
  EXPECT_TRUE(paint.several.empty());
  EXPECT_EQ(paint.width, 4u);
  EXPECT_EQ(paint.missing, std::vector<std::string>{"y"});
  ASSERT_EQ(paint.warnings.notices().size(), 1u);
  EXPECT_EQ(paint.warnings.notices().front().text.plain(),
            "taken from the command line instead: stations, rainfall, width and missing");
}

TEST(StudyFile, TakesFalseForAFlagThatIsNotGiven) {
  Painting paint("stations = 's'\nmend = false\n");
  EXPECT_EQ(paint.refusal(), "");
  EXPECT_FALSE(paint.mend);
  EXPECT_FALSE(paint.options.find("--mend")->is_given());
}

TEST(StudyFile, NamesTheLineOfWhatIsNoOption) {
  EXPECT_EQ(Painting("stations = 's'\n\nwidht = 3\n").refusal(),
            ":3: unknown option 'widht' | did you mean 'width'?");
  EXPECT_EQ(Painting("config = 'a'\n").refusal(), ":1: unknown option 'config'");
  EXPECT_EQ(Painting("\"a\\nb\" = 'a'\n").refusal(), ":1: unknown option 'a\\x0ab'");
}

TEST(StudyFile, NamesTheLineOfAWrongValue) {
  EXPECT_EQ(Painting("stations = 's'\nwidth = 12\n").refusal(),
            ":2: --width wants a whole number from 1 to 9, not '12'");
  EXPECT_EQ(Painting("stations = 's'\nwidth = [1, 2]\n").refusal(),
            ":2: --width is given more than once");
  EXPECT_EQ(Painting("stations = 's'\nmend = 'x'\n").refusal(), ":2: --mend takes no value");
  EXPECT_EQ(Painting("basin_id = 's'\nbasin-id = 's'\n").refusal(),
            ":2: 'basin-id' is given twice");
}

TEST(StudyFile, TellsWhatNeitherGives) {
  EXPECT_EQ(Painting("width = 3\n").refusal(), "STATIONS is missing");
}

TEST(StudyFile, IsWrittenAsItIsReadWithoutTheOutput) {
  Painting paint("");
  EXPECT_EQ(
      paint.refusal({"/in/s.csv", "--rainfall", "/in/a", "--rainfall", "/in/b", "--width", "3",
                     "--tolerance", "0.50", "--mend", "--mend", "--basin-id", "a\"\n#", "-o", "x"}),
      "");
  EXPECT_EQ(paint.written(paint.in_folder("")),
            "stations = \"/in/s.csv\"\nrainfall = [\"/in/a\", \"/in/b\"]\n"
            "basin-id = \"a\\\"\\u000A#\"\nwidth = 3\ntolerance = \"0.50\"\nmend = true\n");
}

TEST(StudyFile, IsTheSameHoweverAFileIsNamed) {
  const std::string wanted = "stations = \"/s\"\nrainfall = \"/r\"\nmissing = \"x\"\n";
  Painting argument("");
  EXPECT_EQ(argument.refusal({"/s", "/r", "--missing", "x"}), "");
  EXPECT_EQ(argument.written("/"), wanted);
  Painting option("");
  EXPECT_EQ(option.refusal({"/s", "--missing", "x", "--rainfall", "/r"}), "");
  EXPECT_EQ(option.written("/"), wanted);
  Painting repeated(wanted);
  EXPECT_EQ(repeated.refusal(), "");
  EXPECT_EQ(repeated.written("/"), wanted);
  EXPECT_EQ(study_options_text(repeated.options), study_options_text(argument.options));
  const std::vector<GivenFile> files = given_files(repeated.options);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[1].option, "rainfall");
  EXPECT_EQ(files[1].file, "/r");
}

TEST(StudyFile, NamesTheLineOfAValueOfAWrongKind) {
  EXPECT_EQ(
      Painting("stations = 's'\nmissing = true\n").refusal(),
      ":2: 'missing' is true, and wants a value | a text stands in quotes: missing = \"true\"");
  EXPECT_EQ(Painting("stations = 5\n").refusal(),
            ":1: 'stations' names a file, and 5 is no text | a text stands in quotes: stations = "
            "\"5\"");
  EXPECT_EQ(Painting("stations = 's'\nmissing = 'true'\nmend = true\n").refusal(), "");
}

TEST(StudyFile, BeginsWithTheVersionAndHowItIsUsed) {
  Painting paint("");
  EXPECT_EQ(paint.refusal({"/s"}), "");
  const std::string text = study_file_text(paint.options, "paint", "/", paint.warnings);
  EXPECT_TRUE(text.starts_with(std::string("# thiessen ") + version() +
                               "\n# Computed again by: thiessen paint --config study.toml"));
}

TEST(StudyFile, IsWrittenWithNamesSeenFromItsFolder) {
  Painting paint("");
  std::filesystem::create_directory(paint.in_folder("out"));
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(paint.in_folder(""));
  EXPECT_EQ(paint.refusal({"in/s.csv", "-"}), "");
  const std::string text = paint.written("out");
  std::filesystem::create_directory_symlink(paint.in_folder(""), "link");
  const std::string by_link = paint.written("link/out");
  std::filesystem::current_path(before);
  EXPECT_EQ(text, "stations = \"../in/s.csv\"\nrainfall = \"-\"\n");
  EXPECT_EQ(by_link, text);
}

TEST(StudyFile, HoldsNoPasswordAndSaysSo) {
  Painting paint("");
  EXPECT_EQ(paint.refusal({"PG:host=h password=secret dbname=d", "pg:postgresql://u:secret@h/d"}),
            "");
  EXPECT_EQ(paint.written("/"),
            "stations = \"PG:host=h  dbname=d\"\nrainfall = \"pg:postgresql://u@h/d\"\n");
  ASSERT_EQ(paint.warnings.messages().size(), 2u);
  EXPECT_EQ(paint.warnings.messages()[0].text.plain(), "the password of STATIONS is left out");
}

TEST(StudyFile, SaysWhatIsNotUtf8) {
  Painting paint("");
  EXPECT_EQ(paint.refusal({"/a\xFF.csv"}), "");
  EXPECT_EQ(paint.written("/"),
            "# stations is not UTF-8, as TOML has to be; give it on the command line\n");
  EXPECT_EQ(paint.warnings.messages().size(), 1u);
}

TEST(StudyFile, is_told_without_the_folders_of_files) {
  Painting painting("");
  const Arguments said =
      parse_arguments({"paint", "some/where/a.csv", "/b/c.csv", "--width", "3", "-o", "x/y.png"},
                      {&painting.options});
  read_options(painting.options, said, painting.warnings);
  EXPECT_EQ(study_options_text(painting.options),
            "stations = \"a.csv\"\nrainfall = \"c.csv\"\nwidth = 3\n");
  const std::vector<GivenFile> files = given_files(painting.options);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].option, "stations");
  EXPECT_EQ(files[0].file, "some/where/a.csv");
  EXPECT_EQ(files[1].option, "rainfall");
}

}  // namespace
}  // namespace thiessen::cli
