#include "cli/help/roff.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen::cli {
namespace {

TEST(Roff, a_sentence_begins_with_a_capital_and_ends_in_one_full_stop) {
  EXPECT_EQ(as_sentence("the weights table"), "The weights table.");
  EXPECT_EQ(as_sentence("Rain."), "Rain.");
}

TEST(Roff, EscapesWhatTheFormatterReads) {
  EXPECT_EQ(roff_phrase("--a\\b"), "\\-\\-a\\eb");
  EXPECT_EQ(roff_paragraph(".dly and 'with'"), "\\&.dly and 'with'\n");
  EXPECT_EQ(roff_paragraph("'with 1'"), "\\&'with 1'\n");
  EXPECT_EQ(roff_verbatim("a\n.b\n"), ".EX\na\n\\&.b\n.EE\n");
}

TEST(Roff, law_1_LinesHaveAtMost80CharactersAndEnd) {
  std::string text;
  for (int i = 0; i < 60; ++i) text += std::string(static_cast<std::size_t>(i % 11 + 1), '-') + " ";
  const std::string lines = roff_paragraph(text);
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = lines.find('\n', at);
    ASSERT_NE(end, std::string::npos);
    EXPECT_LE(end - at, 80u);
    EXPECT_NE(lines[end - 1], ' ');
    at = end + 1;
  }
}

TEST(Roff, FontsEndWhereTheyBegan) {
  EXPECT_EQ(roff_bold("--a"), "\\fB\\-\\-a\\fR");
  EXPECT_EQ(roff_italic("FILE"), "\\fIFILE\\fR");
}

TEST(Roff, AWordThatIsLongerThanALineStandsAlone) {
  const std::string word(100, 'x');
  EXPECT_EQ(roff_paragraph("a " + word + " b"), "a\n" + word + "\nb\n");
  EXPECT_EQ(roff_paragraph(""), "");
}

TEST(Roff, VerbatimKeepsBlanksAndEmptyLines) {
  EXPECT_EQ(roff_verbatim("  a  b\n\n'c"), ".EX\n  a  b\n\n\\&'c\n.EE\n");
}

}  // namespace
}  // namespace thiessen::cli
