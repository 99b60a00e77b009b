#include "files/rainfall/rainfall_folder.h"

#include <gtest/gtest.h>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using Names = std::vector<std::string>;

TEST(RainfallFolder, stands_for_its_files_of_a_format_that_is_read) {
  const TemporaryFolder folder;
  for (const char* name : {"2020.csv", "2019.csv.gz", "s.shp", "s.dbf", "t.dbf", "z.zip", ".x.csv"})
    folder.write(name, "");
  folder.write("about.pdf", "");
  Warnings warnings;
  EXPECT_EQ(rainfall_files({"r.csv", folder.path(), "-"}, warnings),
            (Names{"r.csv", folder.path("2019.csv.gz"), folder.path("2020.csv"),
                   folder.path("s.shp"), folder.path("t.dbf"), folder.path("z.zip"), "-"}));
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(warnings.notices()[0].sentence(),
            folder.path() + ": about.pdf and s.dbf hold no readings, and are passed over");
}

TEST(RainfallFolder, of_dly_files_stands_for_itself) {
  const TemporaryFolder folder;
  folder.write("a.dly", "");
  folder.write("a.csv", "");
  Warnings warnings;
  EXPECT_EQ(rainfall_files({folder.path()}, warnings), Names{folder.path()});
}

TEST(RainfallFolder, without_a_file_of_readings_is_an_error) {
  const TemporaryFolder folder;
  Warnings warnings;
  EXPECT_TRUE(contains(complaint_of([&] { rainfall_files({folder.path()}, warnings); }),
                       folder.path() + ": is a folder without a file of readings"));
}

TEST(RainfallFolder, passes_over_what_is_surely_no_table) {
  const TemporaryFolder folder;
  folder.write("2020.csv", "time,A\n2020-01-01,1\n");
  folder.write("2021.txt", "# daily\ntime;A\n2021-01-01;1,5\n");
  folder.write("readme.txt", "Rain of A, B and others\n\nMeasured, as it were, by hand.\n");
  folder.write("about.json", R"({"title": "Rain", "year": 2020})");
  Warnings warnings;
  EXPECT_EQ(rainfall_files({folder.path()}, warnings),
            (Names{folder.path("2020.csv"), folder.path("2021.txt")}));
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(warnings.notices()[0].sentence(),
            folder.path() + ": about.json and readme.txt hold no readings, and are passed over");
}

}  // namespace
}  // namespace thiessen
