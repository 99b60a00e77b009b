#include "files/rainfall/archived_rainfall.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <utility>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

constexpr const char* dwd = "STATIONS_ID;MESS_DATUM;QN_8;  R1;eor\n1;2024060107;3;0.4;eor\n";
constexpr const char* places = "Stations_id;Hoehe;Stationsname\n1;4.00;A\n2;5.00;B\n";
constexpr const char* table = "time,A\n2020-01-01,4\n";
constexpr const char* prose = "Rain of A, B and others\n\nMeasured by hand.\n";

class ArchivedRainfall : public testing::Test {
 protected:
  /// Makes an archive of these files by another program, in this order.
  std::string archive(const std::vector<std::pair<std::string, std::string>>& files,
                      const std::string& name = "a.zip") const {
    std::string pack =
        "cd '" + folder_.path() + "' && rm -f " + name + " && python3 -m zipfile -c " + name;
    for (const auto& [file, text] : files) {
      folder_.write(file, text);
      pack += " '" + file + "'";
    }
    EXPECT_EQ(std::system(pack.c_str()), 0);
    return folder_.path(name);
  }
  std::string found(const std::string& file) {
    warnings_ = Warnings();
    return file_of_readings(file, warnings_);
  }

  TemporaryFolder folder_;
  Warnings warnings_;
};

TEST_F(ArchivedRainfall, is_the_one_whose_content_is_known) {
  const std::string zip = archive({{"Meta_1.txt", places}, {"p.txt", dwd}, {"Meta_2.txt", places}});
  EXPECT_EQ(found(zip), "/vsizip/" + zip + "/p.txt");
  ASSERT_EQ(warnings_.notices().size(), 1U);
  EXPECT_EQ(warnings_.notices()[0].sentence(),
            "/vsizip/" + zip + "/p.txt: is the file of readings in its archive, and alone is read");
  const std::string other = archive({{"Meta.txt", places}, {"p.txt", dwd}}, "rain");
  EXPECT_EQ(found(other), "/vsizip/{" + other + "}/p.txt");
}

TEST_F(ArchivedRainfall, is_the_one_that_is_a_table) {
  const std::string zip = archive({{"readme.txt", prose}, {"r.txt", table}});
  EXPECT_EQ(found(zip), "/vsizip/" + zip + "/r.txt");
}

TEST_F(ArchivedRainfall, that_is_told_by_its_extension_needs_no_notice) {
  const std::string zip = archive({{"readme.txt", prose}, {"r.csv", table}});
  EXPECT_EQ(found(zip), zip);
  EXPECT_EQ(found(archive({{"r.csv", dwd}}, "b.zip")), folder_.path("b.zip"));
  EXPECT_EQ(found(archive({{"r.csv", table}, {"s.csv", table}}, "c.zip")), folder_.path("c.zip"))
      << "whoever opens it says that there are two";
  EXPECT_EQ(found(folder_.write("r.csv", table)), folder_.path("r.csv"));
  EXPECT_EQ(found("-"), "-");
  EXPECT_TRUE(warnings_.notices().empty());
}

TEST_F(ArchivedRainfall, of_several_has_to_be_named) {
  const std::string zip = archive({{"p.txt", dwd}, {"Meta.txt", places}, {"q.txt", dwd}});
  EXPECT_EQ(complaint_of([&] { found(zip); }),
            zip +
                ": a zip archive of several files of readings: 'p.txt', 'q.txt' | name one as "
                "/vsizip/" +
                zip + "/p.txt, or several, each with 'rainfall'");
}

TEST_F(ArchivedRainfall, of_a_list_of_files_is_the_list) {
  const std::string zip = archive(
      {{"p1.txt", "20000228\n0.5\n"}, {"pcp.txt", "ID,NAME,LAT,LONG,ELEVATION\n1,p1,41,-93,9\n"}});
  EXPECT_EQ(found(zip), "/vsizip/" + zip + "/pcp.txt");
}

}  // namespace
}  // namespace thiessen
