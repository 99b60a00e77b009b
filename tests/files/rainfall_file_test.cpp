#include "files/rainfall_file.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "readings/dly_text.h"

namespace thiessen {
namespace {

const std::vector<Station> stations = {{"USC00050001", {}}};

/// The first reading of the first step.
double first(const std::string& rainfall, const ReadingsOptions& options = {},
             char separator = '\0') {
  Warnings warnings;
  Source source;
  source.file = rainfall;
  source.csv.separator = separator;
  const auto readings = open_rainfall(source, stations, {}, options, warnings);
  TimeStep step;
  EXPECT_TRUE(readings->next(step));
  return step.readings[0];
}

TEST(RainfallFile, is_a_table_or_a_dly_file_or_a_folder_of_them_by_its_name) {
  const TemporaryFolder folder;
  const std::string dly = dly_line(stations[0].id, 2020, 1, {{1, {"125"}}}) + "\n";
  EXPECT_EQ(first(folder.write("a.dly", dly)), 12.5) << "tenths of a millimetre";
  EXPECT_EQ(first(folder.path()), 12.5);
  EXPECT_EQ(first(folder.write("r.csv", "time,USC00050001\n1,3.5\n")), 3.5);
  EXPECT_EQ(first(folder.write("s.csv", "time;USC00050001\n1;4.5\n"), {}, ';'), 4.5);
}

TEST(RainfallFile, flagged_values_are_kept_of_dly_files_alone) {
  const TemporaryFolder folder;
  ReadingsOptions options;
  options.keep_flagged = true;
  const std::string flagged = dly_line(stations[0].id, 2020, 1, {{1, {"125", " X "}}}) + "\n";
  EXPECT_EQ(first(folder.write("a.dly", flagged), options), 12.5);
  const std::string table = folder.write("r.csv", "time,USC00050001\n1,3.5\n");
  EXPECT_EQ(complaint_of([&] { first(table, options); }),
            table + ": 'keep_flagged' is for .dly files of GHCN-Daily");
}

}  // namespace
}  // namespace thiessen
