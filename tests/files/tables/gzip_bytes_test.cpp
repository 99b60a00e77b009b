#include "files/tables/gzip_bytes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

std::string read(const std::string& file, std::size_t piece = 1000) {
  GzipBytes bytes(file);
  std::string all;
  std::string buffer(piece, '\0');
  while (const std::size_t count = bytes.read(buffer.data(), piece)) {
    EXPECT_LE(count, piece);
    all.append(buffer, 0, count);
  }
  EXPECT_EQ(bytes.read(buffer.data(), piece), 0U) << "the end stays the end";
  return all;
}

/// The bytes of another program's gzip of a text.
std::string packed(const TemporaryFolder& folder, const std::string& text) {
  folder.write("plain", text);
  const std::string pack = "cd '" + folder.path() + "' && gzip -c plain >packed";
  EXPECT_EQ(std::system(pack.c_str()), 0);
  return folder.read("packed");
}

TEST(GzipBytes, are_those_of_the_text_in_pieces_of_any_size) {
  const TemporaryFolder folder;
  std::string text = std::string("a\0b", 3);
  for (int i = 0; i < 30'000; ++i) text += std::to_string(i);
  const std::string file = folder.write("a.gz", packed(folder, text));
  for (const std::size_t piece : {std::size_t{1}, std::size_t{1000}, text.size(), 2 * text.size()})
    EXPECT_TRUE(read(file, piece) == text) << piece;
  EXPECT_EQ(read(folder.write("empty.gz", packed(folder, ""))), "");
}

// Programs that append to a file write another member behind the last.
TEST(GzipBytes, of_several_members_follow_one_another) {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "a.gz", packed(folder, "id,x,y\n") + packed(folder, "") + packed(folder, "a,1,2\n"));
  EXPECT_EQ(read(file), "id,x,y\na,1,2\n");
}

TEST(GzipBytes, law_1_no_beginning_of_them_is_whole) {
  const TemporaryFolder folder;
  const std::string whole = packed(folder, "id,x,y\na,1,2\nb,3,4\n");
  for (std::size_t cut = 2; cut < whole.size(); ++cut) {
    const std::string file = folder.write("a.gz", whole.substr(0, cut));
    EXPECT_EQ(complaint_of([&] { read(file); }), file + ": is cut off: the gzip archive has no end")
        << cut;
  }
}

// Whatever came before, an error is told before the text ends.
TEST(GzipBytes, law_2_a_long_text_that_is_cut_off_does_not_end_as_if_it_were_whole) {
  const TemporaryFolder folder;
  std::string text;
  for (unsigned i = 0; i < 100'000; ++i) text += std::to_string(i * 2654435761U);
  const std::string whole = packed(folder, text);
  for (const std::size_t lacking :
       {std::size_t{1}, std::size_t{8}, std::size_t{9}, whole.size() / 2}) {
    const std::string file = folder.write("a.gz", whole.substr(0, whole.size() - lacking));
    for (const std::size_t piece : {std::size_t{100}, std::size_t{100'000}, 2 * text.size()}) {
      EXPECT_TRUE(contains(complaint_of([&] { read(file, piece); }), "is cut off"))
          << lacking << ' ' << piece;
    }
  }
}

// A sum over the text stands behind it. The first two bytes say what kind of file it is.
TEST(GzipBytes, law_3_no_other_text_comes_of_bytes_that_are_damaged) {
  const TemporaryFolder folder;
  const std::string text = "id,x,y\na,1,2\nb,3,4\n";
  const std::string whole = packed(folder, text);
  int refused = 0;
  for (std::size_t at = 2; at < whole.size(); ++at) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << bit));
      const std::string file = folder.write("a.gz", bytes);
      try {
        EXPECT_EQ(read(file), text) << "byte " << at << ", bit " << bit;
      } catch (const Error& error) {
        ++refused;
        EXPECT_TRUE(contains(error.what(), "cannot be unpacked: ") ||
                    contains(error.what(), "is cut off"))
            << error.what();
        EXPECT_FALSE(contains(error.what(), "<fd")) << "zlib's own name for the file";
      }
    }
  }
  EXPECT_GT(refused, 8 * 19) << "all but flips of what says when and where it was packed";
}

TEST(GzipBytes, of_a_file_that_is_not_there_or_a_folder_are_an_error_in_the_systems_words) {
  const TemporaryFolder folder;
  EXPECT_EQ(complaint_of([&] { GzipBytes bytes(folder.path("no.gz")); }),
            folder.path("no.gz") + ": cannot open: No such file or directory");
  EXPECT_EQ(complaint_of([&] { read(folder.path()); }),
            folder.path() + ": cannot be unpacked: Is a directory");
}

std::size_t open_files() {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
    count += entry.path().empty() ? 0U : 1U;
  return count;
}

TEST(GzipBytes, law_4_leave_no_file_open) {
  const TemporaryFolder folder;
  const std::string whole = packed(folder, "text");
  const std::string file = folder.write("a.gz", whole);
  const std::string part = folder.write("part.gz", whole.substr(0, 9));
  const std::size_t before = open_files();
  read(file);
  complaint_of([&] { read(part); });
  EXPECT_EQ(open_files(), before);
}

}  // namespace
}  // namespace thiessen
