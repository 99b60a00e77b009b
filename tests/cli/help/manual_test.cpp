#include "cli/help/manual.h"

#include <gtest/gtest.h>

#include "cli/commands/commands.h"
#include "cli/help/roff.h"

namespace thiessen::cli {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Manual, TellsOfEveryCommandAndEveryOption) {
  const Commands commands("yonder/thiessen");
  const std::string text = manual(commands);
  for (const auto& command : commands.all()) {
    EXPECT_TRUE(has(text, roff_phrase(std::string("thiessen ") + command->name())));
    for (const Option& option : command->options().options())
      EXPECT_TRUE(has(text, roff_phrase(option.name))) << option.name;
  }
  EXPECT_FALSE(has(text, "yonder"));
}

TEST(Manual, TellsOfASharedOptionOnce) {
  const std::string text = manual(Commands("thiessen"));
  const std::string entry = ".TP\n" + roff_bold("--metric") + " ";
  const std::size_t first = text.find(entry);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(text.find(entry, first + 1), std::string::npos);
}

TEST(Manual, ListsTheNamesByWhichFieldsAreFoundAndWhatMeansNoReading) {
  const std::string text = manual(Commands("thiessen"));
  for (const char* name : {"site_no", "easting", "northing", "basin_id", "datetime", "prcp"})
    EXPECT_TRUE(has(text, name)) << name;
  EXPECT_TRUE(has(text, "N/A"));
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

}  // namespace
}  // namespace thiessen::cli
