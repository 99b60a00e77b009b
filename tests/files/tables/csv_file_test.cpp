#include "files/tables/csv_file.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using namespace std::literals;

std::vector<std::string> ids_in(const std::string& file) {
  Warnings warnings;
  const auto csv = open_csv(file, {}, {}, warnings);
  std::vector<std::string> ids;
  for (Row row; csv->next(row);) ids.emplace_back(row.fields[0]);
  return ids;
}

class CsvFile : public testing::Test {
 protected:
  void pack(const std::string& command) const {
    ASSERT_EQ(std::system(("cd '" + folder_.path() + "' && " + command).c_str()), 0);
  }

  TemporaryFolder folder_;
  std::string long_text_ = "id\n";
  std::vector<std::string> ids_;

  void SetUp() override {
    for (int i = 0; i < 20'000; ++i) {
      ids_.push_back(std::to_string(i * 7919 % 100'003));
      long_text_ += ids_.back() + "\n";
    }
    folder_.write("a.csv", long_text_);
  }
};

TEST_F(CsvFile, is_read_from_gzip_of_one_member_or_several) {
  pack("gzip -kn a.csv");
  EXPECT_EQ(ids_in(folder_.path("a.csv.gz")), ids_);
  pack("(head -n 77 a.csv | gzip; tail -n +78 a.csv | gzip) > b.csv.gz");
  EXPECT_EQ(ids_in(folder_.path("b.csv.gz")), ids_);
}

TEST_F(CsvFile, cut_off_or_damaged_is_an_error) {
  pack("gzip -kn a.csv");
  const std::string whole = folder_.read("a.csv.gz");
  for (std::size_t cut = 20; cut < whole.size(); cut += whole.size() / 40) {
    folder_.write("b.csv.gz", std::string_view(whole).substr(0, cut));
    EXPECT_THROW(ids_in(folder_.path("b.csv.gz")), Error) << cut;
  }
  std::string damaged = whole;
  damaged[whole.size() / 2] ^= 0x55;
  EXPECT_THROW(ids_in(folder_.write("c.csv.gz", damaged)), Error);
}

TEST_F(CsvFile, is_read_from_an_archive_of_one) {
  pack("python3 -m zipfile -c a.zip a.csv");
  EXPECT_EQ(ids_in(folder_.path("a.zip")), ids_);
  EXPECT_EQ(ids_in("/vsizip/" + folder_.path("a.zip") + "/a.csv"), ids_);
  Warnings warnings;
  EXPECT_EQ(open_csv(folder_.path("a.zip"), {}, {}, warnings)->again(), nullptr);
}

TEST_F(CsvFile, is_told_in_one_notice_how_it_is_written) {
  const auto notice = [&](const std::string& text, const CsvDialect& said = {}) {
    const std::string file = folder_.write("n.csv", text);
    Warnings warnings;
    open_csv(file, said, {}, warnings);
    EXPECT_LE(warnings.notices().size(), 1U);
    if (warnings.notices().empty()) return std::string();
    return warnings.notices()[0].sentence().substr(file.size() + 2);
  };
  EXPECT_EQ(notice("id,x,y\nA,1.5,2\n"), "");
  EXPECT_EQ(notice("id;x;y\nA;1,5;2\n"),
            "its fields are parted by semicolons, and its numbers have decimal commas");
  EXPECT_EQ(notice("id;x;y\nA;1,5;2\n", {';', true, "", {}}), "");
  EXPECT_EQ(notice("Gauges\n\nid\tx\ty\n\tm\tm\nA\t1\t2\n"),
            "its fields are parted by tabs, its header stands in line 3, below 2 lines that are "
            "passed over, and below its header a line of units (m) is passed over");
  EXPECT_EQ(notice("\xFF\xFEi\0d\0\n\0a\0\n\0"s), "it is written in UTF-16");
}

TEST_F(CsvFile, in_an_archive_that_is_damaged_is_an_error) {
  pack("python3 -m zipfile -c a.zip a.csv");
  std::string bytes = folder_.read("a.zip");
  bytes[200] ^= 0x55;
  EXPECT_THROW(ids_in(folder_.write("b.zip", bytes)), Error);
}

}  // namespace
}  // namespace thiessen
