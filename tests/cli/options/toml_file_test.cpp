#include "cli/options/toml_file.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "base/temporary_folder.h"

namespace thiessen::cli {
namespace {

class TomlFile : public testing::Test {
 protected:
  std::vector<TomlSetting> read(const std::string& text) const {
    return read_toml(folder_.write("study.toml", text));
  }
  /// The line and the text of what is said of a file.
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const Error& error) {
      const Message& message = error.messages().front();
      return std::to_string(message.line) + ": " + message.text.plain();
    }
    return {};
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(TomlFile, GivesKeysInTheOrderOfTheirLines) {
  const auto settings = read("# of a study\nx = 'east'\n\nid = \"gauge\"  # the id\n");
  ASSERT_EQ(settings.size(), 2u);
  EXPECT_EQ(settings[0].key, "x");
  EXPECT_EQ(settings[0].line, 2u);
  EXPECT_EQ(settings[0].texts, std::vector<std::string>{"east"});
  EXPECT_EQ(settings[1].key, "id");
  EXPECT_EQ(settings[1].line, 4u);
}

TEST_F(TomlFile, HasNumbersAsACommandLineHasThem) {
  const auto settings = read("a = 3\nb = -999\nc = 0.5\nd = 1e-3\ne = 0x10\nf = inf\n");
  const std::vector<std::string> expected = {"3", "-999", "0.5", "0.001", "16", "inf"};
  ASSERT_EQ(settings.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(settings[i].texts, std::vector<std::string>{expected[i]});
}

TEST_F(TomlFile, HasTruthsDatesAndArrays) {
  const auto settings =
      read("a = true\nb = false\nc = 1995-05-01\nd = 1995-05-01T06:00:00\ne = ['x', 2]\nf = []\n");
  ASSERT_EQ(settings.size(), 6u);
  EXPECT_EQ(settings[0].texts, std::vector<std::string>{"true"});
  EXPECT_EQ(settings[1].texts, std::vector<std::string>{"false"});
  EXPECT_EQ(settings[2].texts, std::vector<std::string>{"1995-05-01"});
  EXPECT_EQ(settings[3].texts, std::vector<std::string>{"1995-05-01T06:00:00"});
  EXPECT_EQ(settings[4].texts, (std::vector<std::string>{"x", "2"}));
  EXPECT_TRUE(settings[5].texts.empty());
}

TEST_F(TomlFile, TellsTextsFromTruthsAndNumbers) {
  const auto settings =
      read("a = true\nb = 'true'\nc = 5\nd = ['x', 'y']\ne = ['x', 2]\nf = 1995-05-01\n");
  ASSERT_EQ(settings.size(), 6u);
  EXPECT_TRUE(settings[0].is_truth);
  for (std::size_t i = 1; i < 6; ++i) EXPECT_FALSE(settings[i].is_truth) << i;
  const std::vector<bool> are_texts = {false, true, false, true, false, false};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(settings[i].is_text, are_texts[i]) << i;
}

TEST_F(TomlFile, SaysInWhichLineItIsNoToml) {
  EXPECT_TRUE(refusal("id = 'a'\nfrom = 1995-05\n").starts_with("2: this is not TOML: "));
  EXPECT_TRUE(refusal("id = gauge\n").starts_with("1: this is not TOML: "));
  EXPECT_TRUE(refusal("id = 'a'\nid = 'b'\n").starts_with("2: this is not TOML: "));
  EXPECT_TRUE(refusal("title = \"\xFF\"\n").starts_with("1: this is not TOML: "));
}

TEST_F(TomlFile, RefusesTablesAndWhatIsTooLarge) {
  EXPECT_EQ(refusal("id = 'a'\n[run]\nx = 'b'\n"),
            "2: [run] is a table, and options stand in none");
  EXPECT_EQ(refusal("id = [['a']]\n"), "1: an array of options holds texts and numbers");
  EXPECT_EQ(refusal("id = [1,\n true]\n"), "2: an array of options holds texts and numbers");
  EXPECT_EQ(refusal(std::string(2'000'000, '#')),
            "0: this is larger than 1 MB, and no list of options");
}

TEST_F(TomlFile, RefusesATextThatNoCommandLineCanHold) {
  EXPECT_EQ(refusal("id = 'a'\nx = [\"b\", \"c\\u0000d\"]\n"),
            "2: a text with a NUL in it is no option's");
}

TEST_F(TomlFile, ReadsBackEveryTextThatItWrites) {
  std::vector<std::string> texts = {"",       "a\"b",   "a\\b",    "a\nb\r\tc", "#5 = [x], 'y'",
                                    "雨量 ø", "\"\"\"", "\\u0041", "  ",        "\x7F",
                                    "'"};
  for (char c = 1; c < 32; ++c) texts.push_back(std::string("<") + c + ">");
  for (const std::string& text : texts) {
    const auto settings = read("key = " + toml_text(text) + "\n");
    ASSERT_EQ(settings.size(), 1u);
    EXPECT_EQ(settings[0].texts, std::vector<std::string>{text});
  }
}

}  // namespace
}  // namespace thiessen::cli
