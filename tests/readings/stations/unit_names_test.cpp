#include "readings/stations/unit_names.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

const std::vector<Station> stations = {{"a", {}}, {"b", {}}, {"st 1", {}}, {"b_in", {}}, {"p", {}}};

/// A table with this header, with its columns called as the ids alone.
struct Read {
  explicit Read(const std::string& text, const ReadingsOptions& options = {}) {
    const TemporaryFolder folder;
    CsvOptions csv;
    csv.finds_form = true;
    const auto table =
        with_units_in_names(std::make_unique<CsvReader>(folder.write("r.csv", text), csv),
                            ReadingsStations(stations, {}), options);
    header = table->header();
    for (std::size_t i = 0; i < header.size(); ++i) units.push_back(table->unit(i));
    const auto again = table->again();
    EXPECT_EQ(again->header(), header);
    for (Row row; again->next(row);) rows.emplace_back(row.fields.begin(), row.fields.end());
  }

  Texts header;
  Texts units;
  std::vector<Texts> rows;
};

TEST(UnitNames, lose_the_unit_which_is_that_of_the_column) {
  for (const std::string header :
       {"time,a (in),st 1 (in)", "time,a_in,st 1 in", "time,a [inches],st 1.in"}) {
    const Read read(header + "\n2020-01-01,1,2\n");
    EXPECT_EQ(read.header, (Texts{"time", "a", "st 1"})) << header;
    EXPECT_EQ(read.units, (Texts{"", "in", "in"})) << header;
    EXPECT_EQ(read.rows, (std::vector<Texts>{{"2020-01-01", "1", "2"}}));
  }
  EXPECT_EQ(Read("time,a (mm/h)\n").units, (Texts{"", "mm/h"}));
}

TEST(UnitNames, stay_where_they_are_ids_or_no_unit_of_rain) {
  const Texts ids = {"time", "b", "b_in"};
  EXPECT_EQ(Read("time,b,b_in\n").header, ids) << "b_in is a station";
  EXPECT_EQ(Read("time,a,a_in\n").header, (Texts{"time", "a", "a_in"})) << "a is there";
  EXPECT_EQ(Read("time,a_m,b ft,x_in\n").header, (Texts{"time", "a_m", "b ft", "x_in"}));
  EXPECT_EQ(Read("time,station,p (in)\n").header, (Texts{"time", "station", "p (in)"}))
      << "a long table, whose values happen to be called as a station";
}

TEST(UnitNames, have_to_say_the_same_unit_or_the_user_says_one) {
  EXPECT_TRUE(contains(complaint_of([] { Read("time,a (in),st 1 (mm)\n"); }),
                       "r.csv:1: column 'a (in)' is in in by its name, and column 'st 1 (mm)' is "
                       "in mm by its name | 'from_unit' says one unit for all"));
  EXPECT_TRUE(contains(complaint_of([] { Read("time,b,a (in)\n"); }),
                       "column 'b' has no unit in its name, and column 'a (in)' is in in"));
  EXPECT_TRUE(contains(complaint_of([] { Read("time,a (in)\n,mm\n1,2\n"); }),
                       "column 'a (in)' is in in by its name, and in mm by the row below it"));
  EXPECT_EQ(Read("time,a (in)\n,inches\n1,2\n").units, (Texts{"", "in"}));
  ReadingsOptions said;
  said.scale = 1;
  EXPECT_EQ(Read("time,a (in),st 1 (mm)\n", said).header, (Texts{"time", "a", "st 1"}));
}

}  // namespace
}  // namespace thiessen
