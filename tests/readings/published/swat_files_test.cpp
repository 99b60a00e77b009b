#include "readings/published/swat_files.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/file.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

// As chapter 7 of SWAT's documentation and the specification of SWAT+ have them; made up.
constexpr const char* gauges =
    "Station  north,south,\n"
    "Lati    35.0 34.5\n"
    "Long   -81.5-81.0\n"
    "Elev     200  250\n"
    "2000060000.5012.0\n"
    "2000366-99.0003.0\n";
constexpr const char* gauge =
    "p1.pcp: made up\nnbyr     tstep       lat      long      elev\n   1   0   35.0   -81.5   "
    "200.0\n"
    "2001   365   0.5\n2002   1   -99.0\n";

InputFile open_plain(const std::string& file) {
  return InputFile(file);
}

class SwatFilesTest : public testing::Test {
 protected:
  std::vector<std::string> rows(const std::string& file, SwatFile kind) {
    SwatRainfall table(file, kind, open_plain);
    std::vector<std::string> all;
    for (Row row; table.next(row);) {
      std::string text;
      for (const std::string_view field : row.fields) text += std::string(field) + " ";
      all.push_back(text);
    }
    return all;
  }

  const TemporaryFolder folder_;
};

TEST_F(SwatFilesTest, are_known_by_their_first_lines) {
  EXPECT_EQ(swat_file(gauges), SwatFile::gauges);
  EXPECT_EQ(swat_file(gauge), SwatFile::gauge);
  EXPECT_EQ(swat_file("pcp.cli: made up\r\nfilename\r\np1.pcp\r\n"), SwatFile::list);
  EXPECT_EQ(swat_file("Station,Lat,Lon\n"), SwatFile::none);
  EXPECT_EQ(swat_file(""), SwatFile::none);
}

TEST_F(SwatFilesTest, of_gauges_have_five_characters_a_value) {
  EXPECT_EQ(rows(folder_.write("pcp1.pcp", gauges), SwatFile::gauges),
            (std::vector<std::string>{"north 2000-02-29 000.5 ", "south 2000-02-29 012.0 ",
                                      "north 2000-12-31 -99.0 ", "south 2000-12-31 003.0 "}));
}

TEST_F(SwatFilesTest, of_a_list_are_read_one_after_the_other) {
  folder_.write("p1.pcp", gauge);
  folder_.write("p2.pcp", gauge);
  EXPECT_EQ(rows(folder_.write("pcp.cli", "list\nfilename\np1.pcp\np2.pcp\n"), SwatFile::list),
            (std::vector<std::string>{"p1 2001-12-31 0.5 ", "p1 2002-01-01 -99.0 ",
                                      "p2 2001-12-31 0.5 ", "p2 2002-01-01 -99.0 "}));
}

TEST_F(SwatFilesTest, place_their_gauges) {
  const auto found = swat_gauges(folder_.write("pcp1.pcp", gauges), SwatFile::gauges, open_plain);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].id, "south");
  EXPECT_EQ(found[1].latitude, "34.5");
  EXPECT_EQ(found[1].longitude, "-81.0");
  const auto one = swat_gauges(folder_.write("p1.pcp", gauge), SwatFile::gauge, open_plain);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].id, "p1");
  EXPECT_EQ(one[0].longitude, "-81.5");
}

TEST_F(SwatFilesTest, name_every_line_that_is_none) {
  const std::string file =
      folder_.write("pcp1.pcp", std::string(gauges) + "2001366000.5012.0\n2001001000.5\n");
  const auto found = complaints_of([&] { rows(file, SwatFile::gauges); });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], file + ":7: no year, day of the year and rain: '2001366000.5012.0'");
}

TEST_F(SwatFilesTest, of_shorter_steps_are_refused) {
  std::string text = gauge;
  text.replace(text.find("   0   35"), 4, "   24");
  const std::string file = folder_.write("p1.pcp", text);
  EXPECT_EQ(complaint_of([&] { rows(file, SwatFile::gauge); }),
            file + ":3: its steps are shorter than a day (tstep 24), which is not read");
}

constexpr const char* heads =
    "Station  north,south,\nLati    35.0 34.5\nLong   -81.5-81.0\nElev     200  250\n";

TEST_F(SwatFilesTest, of_shorter_steps_have_a_clock) {
  EXPECT_EQ(
      rows(folder_.write("p.pcp", std::string(heads) + "200036600:00004.0008.0\n"
                                                       "200036612:30  0.5-99.0\n"
                                                       "200100100:00  1.00  2.25\n"),
           SwatFile::gauges),
      (std::vector<std::string>{"north 2000-12-31T00:00 004.0 ", "south 2000-12-31T00:00 008.0 ",
                                "north 2000-12-31T12:30 0.5 ", "south 2000-12-31T12:30 -99.0 ",
                                "north 2001-01-01T00:00 1.00 ", "south 2001-01-01T00:00 2.25 "}));
}

TEST_F(SwatFilesTest, of_shorter_steps_have_them_on_a_dry_day_too) {
  const std::string text = std::string(heads) +
                           "2000364     000.0-99.0\n"
                           "200036500:00004.0008.0\n200036512:00001.0001.0\n"
                           "2000366     000.0000.0\n";
  EXPECT_EQ(
      rows(folder_.write("p.pcp", text), SwatFile::gauges),
      (std::vector<std::string>{"north 2000-12-29T00:00 000.0 ", "south 2000-12-29T00:00 -99.0 ",
                                "north 2000-12-29T12:00 000.0 ", "south 2000-12-29T12:00 -99.0 ",
                                "north 2000-12-30T00:00 004.0 ", "south 2000-12-30T00:00 008.0 ",
                                "north 2000-12-30T12:00 001.0 ", "south 2000-12-30T12:00 001.0 ",
                                "north 2000-12-31T00:00 000.0 ", "south 2000-12-31T00:00 000.0 ",
                                "north 2000-12-31T12:00 000.0 ", "south 2000-12-31T12:00 000.0 "}));
}

TEST_F(SwatFilesTest, of_shorter_steps_name_every_line_that_is_none) {
  const std::string text = std::string(heads) +
                           "200036500:00004.0008.0\n"
                           "200036524:00004.0008.0\n"
                           "200036501:00004.0\n"
                           "2000366     001.0000.0\n"
                           "2000366001.0000.0\n";
  const std::string file = folder_.write("p.pcp", text);
  EXPECT_EQ(complaints_of([&] { rows(file, SwatFile::gauges); }),
            (std::vector<std::string>{
                file + ":6: no year, day of the year, clock and rain: '200036524:00004.0008.0'",
                file + ":7: no year, day of the year, clock and rain: '200036501:00004.0'",
                file + ":8: rain of a whole day among steps that are shorter: "
                       "'2000366     001.0000.0'",
                file + ":9: no year, day of the year, clock and rain: '2000366001.0000.0'"}));
}

}  // namespace
}  // namespace thiessen
