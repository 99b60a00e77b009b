#include "cli/outputs/encoded_files.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "base/temporary_folder.h"

namespace thiessen::cli {
namespace {

TEST(EncodedFiles, are_written_beside_the_first_and_older_side_files_go) {
  const TemporaryFolder folder;
  for (const char* name : {"c.shp", "c.dbf", "c.qix", "c.txt", "d.qix"}) folder.write(name, "old");
  Outputs outputs({true, {}});
  OutputFile& file = outputs.add(folder.path("c.shp"));
  append_files(outputs, file,
               {{folder.path("c.shp"), "shapes"},
                {folder.path("c.dbf"), "table"},
                {folder.path("c.shx"), "index"}});
  EXPECT_EQ(folder.read("c.qix"), "old") << "until all is written";
  outputs.commit();
  EXPECT_EQ(folder.names(), (std::set<std::string>{"c.shp", "c.dbf", "c.shx", "c.txt", "d.qix"}));
  EXPECT_EQ(folder.read("c.shp"), "shapes");
  EXPECT_EQ(folder.read("c.dbf"), "table");
  EXPECT_EQ(folder.read("c.shx"), "index");
}

TEST(EncodedFiles, of_one_file_are_that_file) {
  const TemporaryFolder folder;
  Outputs outputs({});
  append_files(outputs, outputs.add(folder.path("c.kml")), {{folder.path("c.kml"), "cells"}});
  outputs.commit();
  EXPECT_EQ(folder.names(), std::set<std::string>{"c.kml"});
  EXPECT_EQ(folder.read("c.kml"), "cells");
}

}  // namespace
}  // namespace thiessen::cli
