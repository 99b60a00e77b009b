#include "cli/session/loaded_file.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>

#include "base/temporary_folder.h"

namespace thiessen::cli {
namespace {

/// All of a file, read in small pieces.
std::string read_all(InputFile file) {
  std::string text;
  std::array<char, 100> piece{};
  while (const std::size_t count = file.read(piece)) text.append(piece.data(), count);
  return text;
}

void expect(const std::string& text, bool is_table) {
  const TemporaryFolder folder;
  LoadedFile loaded(folder.write("f", text));
  EXPECT_EQ(loaded.is_table(), is_table) << text.substr(0, 60);
  EXPECT_EQ(read_all(std::move(loaded).input()), text);
}

TEST(LoadedFile, is_known_by_its_first_line_and_read_from_its_beginning) {
  expect("point 1 0 0\npoint 2 1 1\n", true);
  expect("\xEF\xBB\xBF\r\n# saved\r\n  point 1 0 0\r\n", true);
  expect("point 1 0 0", true);
  expect("x,y\n1,2\n", false);
  expect("", false);
  expect("\n\n", false);
  expect(std::string(20000, '\n') + "point 1 0 0\n", true);
  expect(std::string(200000, 'x'), false);
}

}  // namespace
}  // namespace thiessen::cli
