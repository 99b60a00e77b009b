#include "readings/published/arcswat_files.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/file.h"

namespace thiessen {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// Opens texts by their names.
OpenNamed opening(std::map<std::string, std::string> texts) {
  return [texts](const std::string& file) {
    const auto found = texts.find(file);
    if (found == texts.end()) throw Error({file, 0, "cannot open", ""});
    return InputFile(file,
                     [text = found->second, at = std::size_t{0}](std::span<char> into) mutable {
                       const std::size_t count = text.copy(into.data(), into.size(), at);
                       at += count;
                       return count;
                     });
  };
}

Rows rows_of(Table& table) {
  Rows rows;
  for (Row row; table.next(row);) rows.emplace_back(row.fields.begin(), row.fields.end());
  return rows;
}

TEST(ArcSwatFiles, are_known_by_their_beginning) {
  EXPECT_EQ(arcswat_file("ID,NAME,LAT,LONG,ELEVATION\r\n1,p1,41,-93,296\n"), ArcSwatFile::list);
  EXPECT_EQ(arcswat_file("20000228\n0.5\n"), ArcSwatFile::gauge);
  EXPECT_EQ(arcswat_file("20000228\r\n-99\r\n"), ArcSwatFile::gauge);
  EXPECT_EQ(arcswat_file("20000228\n10.1,2.2\n"), ArcSwatFile::none);  // temperatures
  EXPECT_EQ(arcswat_file("20000230\n0.5\n"), ArcSwatFile::none);       // no such day
  EXPECT_EQ(arcswat_file("id,name,lat,long\n"), ArcSwatFile::none);
  EXPECT_EQ(arcswat_file(""), ArcSwatFile::none);
}

TEST(ArcSwatFiles, a_gauge_has_a_day_a_line) {
  ArcSwatRainfall table("p1.txt", ArcSwatFile::gauge,
                        opening({{"p1.txt", "20000228\n0.5\n-99\n7\n"}}));
  EXPECT_EQ(rows_of(table),
            (Rows{{"2000-02-28", "0.5"}, {"2000-02-29", "-99"}, {"2000-03-01", "7"}}));
}

TEST(ArcSwatFiles, a_list_names_files_beside_it) {
  ArcSwatRainfall table(
      "a/pcp.txt", ArcSwatFile::list,
      opening({{"a/pcp.txt", "ID,NAME,LAT,LONG,ELEVATION\n1,p1,41,-93,9\n7,p2.txt,42,-94,8\n"},
               {"a/p1.txt", "19991231\n0.5\n1\n"},
               {"a/p2.txt", "20000101\n2\n"}}));
  EXPECT_EQ(rows_of(table),
            (Rows{{"1", "1999-12-31", "0.5"}, {"1", "2000-01-01", "1"}, {"7", "2000-01-01", "2"}}));
  EXPECT_EQ(rows_of(*table.again()).size(), 3U);
}

TEST(ArcSwatFiles, faults_have_their_file_and_line) {
  ArcSwatRainfall table("pcp.txt", ArcSwatFile::list,
                        opening({{"pcp.txt", "ID,NAME,LAT,LONG,ELEVATION\n1,p1,41,-93,9\n"},
                                 {"p1.txt", "20000228\n0.5\n-1\nx\n"}}));
  try {
    rows_of(table);
    FAIL() << "no error";
  } catch (const Error& error) {
    ASSERT_EQ(error.messages().size(), 2U);
    EXPECT_EQ(error.messages()[0].file, "p1.txt");
    EXPECT_EQ(error.messages()[0].line, 3U);
    EXPECT_EQ(error.messages()[1].line, 4U);
  }
  EXPECT_THROW(ArcSwatRainfall("e.txt", ArcSwatFile::list,
                               opening({{"e.txt", "ID,NAME,LAT,LONG,ELEVATION\n"}})),
               Error);
}

TEST(ArcSwatFiles, of_a_list_are_named_with_its_folder) {
  const auto open =
      opening({{"a/pcp.txt", "ID,NAME,LAT,LONG,ELEVATION\n1,p1,41,-93,9\n7,P2.TXT,42,-94,8\n"}});
  EXPECT_EQ(files_of_arcswat_list("a/pcp.txt", open),
            (std::vector<std::string>{"a/p1.txt", "a/P2.TXT"}));
}

}  // namespace
}  // namespace thiessen
