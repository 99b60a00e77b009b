#include "gdal/output/disk_file.h"

#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include <string>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

TEST(DiskFile, is_written_read_and_cut_like_any_other) {
  const TemporaryFolder folder;
  const DiskFile disk(folder.path("a: b?.tif"), "out/a: b?.tif");
  VSILFILE* const file = VSIFOpenL(disk.name_for_gdal().c_str(), "w+b");
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(VSIFWriteL("0123456789", 1, 10, file), 10U);
  EXPECT_EQ(VSIFSeekL(file, 12, SEEK_SET), 0);
  EXPECT_EQ(VSIFWriteL("ab", 2, 1, file), 1U);
  EXPECT_EQ(VSIFTellL(file), 14U);
  EXPECT_EQ(VSIFSeekL(file, 8, SEEK_SET), 0);
  std::string read(10, '?');
  EXPECT_EQ(VSIFReadL(read.data(), 1, 10, file), 6U);
  EXPECT_EQ(read, std::string("89\0\0ab????", 10));
  EXPECT_NE(VSIFEofL(file), 0);
  EXPECT_EQ(VSIFSeekL(file, 0, SEEK_END), 0);
  EXPECT_EQ(VSIFTellL(file), 14U);
  EXPECT_EQ(VSIFTruncateL(file, 4), 0);
  EXPECT_EQ(VSIFCloseL(file), 0);
  EXPECT_NO_THROW(disk.check());
  EXPECT_EQ(folder.read("a: b?.tif"), "0123");
  VSIStatBufL status;
  EXPECT_EQ(VSIStatL(disk.name_for_gdal().c_str(), &status), 0);
  EXPECT_EQ(status.st_size, 4);
  EXPECT_NE(VSIStatL((disk.name_for_gdal() + ".aux.xml").c_str(), &status), 0);
}

TEST(DiskFile, gives_its_side_files_the_names_that_the_user_wants_and_takes_them_away) {
  const TemporaryFolder folder;
  const DiskFile disk(folder.path("r.tif"), "out/r.tif");
  folder.write("r.tif", "tif");
  folder.write("r.tif.aux.xml", "xml");
  const auto files = disk.take();
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, "out/r.tif");
  EXPECT_EQ(files[0].bytes, "");
  EXPECT_EQ(files[1].name, "out/r.tif.aux.xml");
  EXPECT_EQ(files[1].bytes, "xml");
  EXPECT_EQ(folder.names().size(), 1U);
}

// A device that is always full stands for the disk.
TEST(DiskFile, notices_a_full_disk_whatever_is_made_of_what_could_not_be_written) {
  const DiskFile disk("/dev/full", "out/r.tif");
  VSILFILE* const file = VSIFOpenL(disk.name_for_gdal().c_str(), "wb");
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(VSIFWriteL("0123", 1, 4, file), 0U);
  VSIFCloseL(file);
  EXPECT_EQ(complaint_of([&] { disk.check(); }),
            "out/r.tif: cannot write: No space left on device");
  EXPECT_EQ(complaint_of([&] { disk.take(); }), "out/r.tif: cannot write: No space left on device");
}

TEST(DiskFile, that_cannot_be_made_is_noticed_too) {
  const TemporaryFolder folder;
  const DiskFile disk(folder.path("nowhere/r.tif"), "r.tif");
  EXPECT_EQ(VSIFOpenL(disk.name_for_gdal().c_str(), "wb"), nullptr);
  EXPECT_EQ(complaint_of([&] { disk.check(); }), "r.tif: cannot write: No such file or directory");
}

}  // namespace
}  // namespace thiessen
