#include "files/tables/dwd_station_list.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

// As DWD's RR_Tageswerte_Beschreibung_Stationen.txt has it, in Latin-1; the lines are made up.
constexpr const char* lines =
    "Stations_id von_datum bis_datum Stationshoehe geoBreite geoLaenge Stationsname Bundesland "
    "Abgabe\r\n"
    "----------- --------- --------- ------------- --------- --------- ------------ ---------- "
    "------\r\n"
    "00164 19080101 20241231             54     53.0316   13.9908 Angerm\xFCnde      Brandenburg  "
    "    Frei\r\n"
    "01441 19920601 20241231            120     50.9000   13.3400 Frauenstein (Erzgeb.)    "
    "Sachsen    Frei\r\n";

std::vector<std::vector<std::string>> rows_of(DwdStationList& list) {
  std::vector<std::vector<std::string>> rows;
  for (Row row; list.next(row);) rows.emplace_back(row.fields.begin(), row.fields.end());
  return rows;
}

TEST(DwdStationList, is_known_by_its_header) {
  const TemporaryFolder folder;
  EXPECT_TRUE(is_dwd_station_list(folder.write("a.txt", lines)));
  for (const char* other : {"id,lon,lat\n", "", "Stations_id;geoBreite;geoLaenge\n"})
    EXPECT_FALSE(is_dwd_station_list(folder.write("b.txt", other))) << other;
  EXPECT_FALSE(is_dwd_station_list(folder.path() + "/none"));
}

TEST(DwdStationList, is_a_table_with_names_of_several_words) {
  const TemporaryFolder folder;
  DwdStationList list(folder.write("a.txt", lines));
  EXPECT_EQ(rows_of(list), (std::vector<std::vector<std::string>>{
                               {"00164", "19080101", "20241231", "54", "53.0316", "13.9908",
                                "Angermünde", "Brandenburg"},
                               {"01441", "19920601", "20241231", "120", "50.9000", "13.3400",
                                "Frauenstein (Erzgeb.)", "Sachsen"}}));
}

TEST(DwdStationList, names_every_line_that_is_none) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.txt", std::string(lines) + "cut\n");
  DwdStationList list(file);
  EXPECT_EQ(complaint_of([&] { rows_of(list); }),
            file + ":5: is no line of DWD's list of stations: 'cut'");
}

}  // namespace
}  // namespace thiessen
