#include "files/tables/skipped_lines.h"

#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

constexpr const char* hint =
    "'skip' is of all CSV files, and 'rainfall_skip', 'stations_skip' and 'basins_skip' are of one "
    "each";

std::string told(const Message& message, std::optional<std::size_t> skip, bool is_of_all) {
  Source source;
  source.file = message.file;
  source.csv.skip = skip;
  source.csv.skip_is_of_all = is_of_all;
  return complaint_of([&] { throw told_of_skip(Error(message), source); });
}

TEST(SkippedLines, of_all_files_are_spoken_of_where_a_header_is_wrong) {
  EXPECT_EQ(told({"s.csv", 4, "no field", ""}, 3, true),
            std::string("s.csv:4: no field | ") + hint);
  EXPECT_EQ(told({"s.csv", 4, "no field", "name it"}, 3, true),
            std::string("s.csv:4: no field | ") + hint + "; else name it");
}

TEST(SkippedLines, are_not_spoken_of_elsewhere) {
  EXPECT_EQ(told({"s.csv", 4, "no field", ""}, 3, false), "s.csv:4: no field");
  EXPECT_EQ(told({"s.csv", 1, "no field", ""}, 0, true), "s.csv:1: no field");
  EXPECT_EQ(told({"s.csv", 5, "a bad row", ""}, 3, true), "s.csv:5: a bad row");
  EXPECT_EQ(told({"s.geojson", 1, "no JSON", ""}, 3, true), "s.geojson:1: no JSON");
}

}  // namespace
}  // namespace thiessen
