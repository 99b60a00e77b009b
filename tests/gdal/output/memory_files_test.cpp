#include "gdal/output/memory_files.h"

#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

void write(const std::string& path, const std::string& bytes) {
  VSILFILE* file = VSIFOpenL(path.c_str(), "wb");
  ASSERT_NE(file, nullptr) << path;
  EXPECT_EQ(VSIFWriteL(bytes.data(), 1, bytes.size(), file), bytes.size());
  VSIFCloseL(file);
}

bool exists(const std::string& path) {
  VSIStatBufL status;
  return VSIStatL(path.c_str(), &status) == 0;
}

/// The path in memory with another extension.
std::string beside(const std::string& file, const std::string& extension) {
  return file.substr(0, file.rfind('.')) + extension;
}

TEST(MemoryFolder, gives_the_files_the_names_that_the_user_wants_the_main_one_first) {
  const MemoryFolder folder("a.b/my cells\n.shp");
  EXPECT_TRUE(folder.file().starts_with("/vsimem/"));
  EXPECT_TRUE(folder.file().ends_with(".shp"));
  EXPECT_EQ(folder.file().find("my"), std::string::npos) << "a user's name may hold anything";
  write(beside(folder.file(), ".prj"), "prj");
  write(beside(folder.file(), ".dbf"), std::string("d\0f", 3));
  write(folder.file(), "shp");
  const auto files = folder.take();
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files[0].name, "a.b/my cells\n.shp");
  EXPECT_EQ(files[0].bytes, "shp");
  EXPECT_EQ(files[1].name, "a.b/my cells\n.dbf");
  EXPECT_EQ(files[1].bytes, std::string("d\0f", 3));
  EXPECT_EQ(files[2].name, "a.b/my cells\n.prj");
}

TEST(MemoryFolder, keeps_the_extension_that_tells_gdal_the_format) {
  EXPECT_TRUE(MemoryFolder("x.shp.zip").file().ends_with("/cells.shp.zip"));
  EXPECT_TRUE(MemoryFolder("a.b/c").file().ends_with("/cells"));
  EXPECT_TRUE(MemoryFolder("d/.gpkg").file().ends_with("/cells"));
  EXPECT_TRUE(MemoryFolder("x.y.GPKG").file().ends_with("/cells.GPKG"));
}

TEST(MemoryFolder, is_of_one_dataset_alone_and_gone_with_it) {
  std::string file;
  {
    const MemoryFolder one("c.fgb");
    const MemoryFolder other("c.fgb");
    EXPECT_NE(one.file(), other.file());
    write(one.file(), "bytes");
    EXPECT_EQ(complaint_of([&] { other.take(); }), "c.fgb: GDAL wrote nothing");
    EXPECT_TRUE(exists(one.file()));
    file = one.file();
  }
  EXPECT_FALSE(exists(file));
}

TEST(MemoryFolder, refuses_a_format_that_is_a_folder) {
  const MemoryFolder folder("c.gdb");
  write(folder.file(), "");
  const std::string below = folder.file().substr(0, folder.file().rfind('/')) + "/cells_more";
  VSIMkdir(below.c_str(), 0755);
  write(below + "/table", "x");
  EXPECT_EQ(complaint_of([&] { folder.take(); }),
            "c.gdb: this format is a folder, which is not written");
}

}  // namespace
}  // namespace thiessen
