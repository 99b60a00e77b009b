#include "files/tables/packed_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

const std::string text = "id,x,y\na,1,2\n";

std::string read(const std::string& file) {
  InputFile input = open_text(file);
  EXPECT_EQ(input.name(), file);
  std::string all;
  std::array<char, 5> bytes{};
  while (const std::size_t count = input.read(bytes)) all.append(bytes.data(), count);
  return all;
}

/// The text by itself, and as other programs pack it.
struct Packed {
  Packed() {
    folder.write("a.csv", text);
    const std::string pack = "cd '" + folder.path() +
                             "' && gzip -k a.csv && cp a.csv.gz gauges"
                             " && python3 -m zipfile -c a.zip a.csv";
    EXPECT_EQ(std::system(pack.c_str()), 0);
  }
  TemporaryFolder folder;
};

/// It is packed once, because starting the other programs takes longest.
const Packed& packed() {
  static const Packed once;
  return once;
}

TEST(PackedFile, law_1_a_text_is_the_same_however_it_is_packed) {
  for (const char* name : {"a.csv", "a.csv.gz", "gauges", "a.zip"}) {
    const std::string file = packed().folder.path(name);
    EXPECT_EQ(read(file), text) << name;
    EXPECT_EQ(beginning_of_text(file, 4), "id,x") << name;
    EXPECT_EQ(beginning_of_text(file, text.size()), text) << name;
    EXPECT_EQ(beginning_of_text(file, 4096), text) << name << " is shorter";
  }
  const std::string inside = "/vsizip/" + packed().folder.path("a.zip") + "/a.csv";
  EXPECT_EQ(read(inside), text);
  EXPECT_EQ(beginning_of_text(inside, 4), "id,x");
  EXPECT_EQ(beginning_of_text("/vsizip/" + packed().folder.path("a.zip") + "/no.csv", 4), "");
}

TEST(PackedFile, that_cannot_be_opened_is_an_error_and_has_no_beginning) {
  EXPECT_EQ(complaint_of([&] { read(packed().folder.path("no.csv")); }),
            packed().folder.path("no.csv") + ": No such file or directory");
  EXPECT_EQ(beginning_of_text(packed().folder.path("no.csv"), 9), "");
  EXPECT_EQ(beginning_of_text(packed().folder.path(), 9), "");
  EXPECT_EQ(beginning_of_text("", 9), "");
  EXPECT_EQ(beginning_of_text("-", 9), "");
}

TEST(PackedFile, has_no_beginning_where_it_can_be_read_only_once) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(beginning_of_text(pipe, 9), "") << "nor does it wait for one";
}

TEST(PackedFile, has_no_beginning_where_it_is_no_text_or_is_damaged) {
  const TemporaryFolder& folder = packed().folder;
  EXPECT_EQ(beginning_of_text(folder.write("a.geojson", "{\"type\":\"Point\"}"), 9), "");
  const std::string gzip = folder.read("a.csv.gz");
  EXPECT_EQ(beginning_of_text(folder.write("b.csv.gz", gzip.substr(0, gzip.size() - 1)), 4096), "");
  const std::string zip = folder.read("a.zip");
  EXPECT_EQ(beginning_of_text(folder.write("b.zip", zip.substr(0, zip.size() / 2)), 4096), "");
}

}  // namespace
}  // namespace thiessen
