#include "gdal/layers/vsi_bytes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

/// All bytes, read so many at a time.
std::string read(const std::string& name, std::size_t piece) {
  VsiBytes bytes("f", name);
  std::string all;
  std::string buffer(piece, '\0');
  while (const std::size_t count = bytes.read(buffer.data(), piece)) {
    EXPECT_LE(count, piece);
    all.append(buffer, 0, count);
  }
  EXPECT_EQ(bytes.read(buffer.data(), piece), 0U) << "the end stays the end";
  return all;
}

TEST(VsiBytes, are_those_of_a_file_in_pieces_of_any_size) {
  const TemporaryFolder folder;
  std::string text = std::string("a\0b", 3);
  for (int i = 0; i < 30'000; ++i) text += std::to_string(i);
  const std::string file = folder.write("f", text);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{1000}, text.size(), 2 * text.size()})
    EXPECT_TRUE(read(file, piece) == text) << piece;
  EXPECT_EQ(read(folder.write("empty", ""), 10), "");
}

TEST(VsiBytes, may_stand_in_an_archive) {
  const TemporaryFolder folder;
  folder.write("a.json", "{\"a\":1}");
  const std::string pack = "cd '" + folder.path() + "' && gzip -k a.json";
  ASSERT_EQ(std::system(pack.c_str()), 0);
  EXPECT_EQ(read("/vsigzip/" + folder.path("a.json.gz"), 4), "{\"a\":1}");
}

TEST(VsiBytes, of_a_file_that_is_not_there_are_an_error_by_the_users_name) {
  const TemporaryFolder folder;
  EXPECT_EQ(complaint_of([&] { VsiBytes("basins.json", folder.path("no")); }),
            "basins.json: cannot be opened");
}

}  // namespace
}  // namespace thiessen
