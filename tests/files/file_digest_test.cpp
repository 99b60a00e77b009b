#include "files/file_digest.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "base/temporary_folder.h"

namespace thiessen {
namespace {

// Of FIPS 180-2's examples, appendix B.1.
constexpr const char* of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr const char* of_nothing =
    "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";

TEST(FileDigest, is_sha256) {
  TemporaryFolder folder;
  const std::vector<FileDigest> digests = digests_of(folder.write("abc.csv", "abc"));
  ASSERT_EQ(digests.size(), 1U);
  EXPECT_EQ(digests[0].name, "abc.csv");
  EXPECT_EQ(digests[0].sha256, of_abc);
  EXPECT_EQ(digests_of(folder.write("empty.csv", ""))[0].sha256, of_nothing);
}

TEST(FileDigest, is_of_each_part_of_a_shapefile) {
  TemporaryFolder folder;
  const auto shapes = folder.write("a.shp", "abc");
  folder.write("a.dbf", "");
  folder.write("b.dbf", "");
  const std::vector<FileDigest> digests = digests_of(shapes);
  ASSERT_EQ(digests.size(), 2U);
  EXPECT_EQ(digests[1].name, "a.dbf");
  EXPECT_EQ(digests[1].sha256, of_nothing);
}

TEST(FileDigest, is_of_each_file_of_a_folder_by_name) {
  TemporaryFolder folder;
  folder.write("b.csv", "");
  const auto file = folder.write("a.csv", "abc");
  const auto digests = digests_of(std::filesystem::path(file).parent_path().string());
  ASSERT_EQ(digests.size(), 2U);
  EXPECT_EQ(digests[0].name, "a.csv");
  EXPECT_EQ(digests[1].name, "b.csv");
}

TEST(FileDigest, is_none_of_what_is_no_file) {
  EXPECT_EQ(digests_of("-")[0].sha256, "none: it is no plain file");
  EXPECT_EQ(digests_of("PG:dbname=rain")[0].sha256, "none: it is no plain file");
}

}  // namespace
}  // namespace thiessen
