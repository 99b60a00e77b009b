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

TEST(Manual, NamesTheLibraryTheModuleAndTheirPages) {
  const std::string text = manual(Commands("thiessen"));
  for (const char* name : {"<thiessen.h>", "find_package(thiessen)", "samples/library",
                           "samples/python", "samples/qgis", "samples/r", "samples/jobs"})
    EXPECT_TRUE(has(text, name)) << name;
}

}  // namespace
}  // namespace thiessen::cli
