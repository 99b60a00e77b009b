#include "readings/published/published_table.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "readings/published/published_formats.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

constexpr const char* by_year =
    "ID,DATE,ELEMENT,DATA_VALUE,M_FLAG,Q_FLAG,S_FLAG,OBS_TIME\n"
    "A,20200101,TMAX,183,,,7,\n"
    "A,20200101,PRCP,254,,,7,\n"
    "A,20200102,PRCP,9999,,G,7,\n"
    "A,20200103,PRCP,0,T,,7,\n";

class PublishedTableTest : public testing::Test {
 protected:
  const PublishedFormat& open(const std::string& text, const ReadingsOptions& options = {}) {
    auto csv = std::make_unique<CsvReader>(folder_.write("r.csv", text));
    const PublishedFormat& format = *format_of_header(csv->header());
    table_ = std::make_unique<PublishedTable>(std::move(csv), format, options, warnings_);
    return format;
  }

  /// The values of the rows, parted by blanks; an empty one is -.
  std::string values(Table& table, std::size_t column) {
    std::string all;
    for (Row row; table.next(row);)
      all += (row.fields[column].empty() ? "-" : std::string(row.fields[column])) + " ";
    return all;
  }

  const TemporaryFolder folder_;
  Warnings warnings_;
  std::unique_ptr<Table> table_;
};

TEST_F(PublishedTableTest, has_rows_of_rain_without_flags) {
  open(by_year);
  EXPECT_EQ(values(*table_, 3), "254 - 0 ");
  ASSERT_EQ(warnings_.notices().size(), 1U);
  EXPECT_EQ(values(*table_->again(), 3), "254 - 0 ");
  EXPECT_EQ(warnings_.notices().size(), 1U) << "told once";
}

TEST_F(PublishedTableTest, keeps_flagged_values_where_it_is_asked_to) {
  ReadingsOptions options;
  options.keep_flagged = true;
  open(by_year, options);
  EXPECT_EQ(values(*table_, 3), "254 9999 0 ");
  EXPECT_TRUE(warnings_.notices().empty());
}

TEST_F(PublishedTableTest, a_fraction_shows_another_unit) {
  open("ID,DATE,ELEMENT,DATA_VALUE,M_FLAG,Q_FLAG,S_FLAG\nA,20200101,PRCP,25.4,,,7\n");
  EXPECT_EQ(
      complaint_of([&] { values(*table_, 3); }),
      folder_.path() +
          "/r.csv:2: '25.4' is no whole number, so that the values are not in tenths of a "
          "millimetre, as NOAA's GHCN-Daily by year or by station has them | from_unit = mm or "
          "from_unit = in says what they are in");
}

TEST_F(PublishedTableTest, amounts_of_several_days_are_no_readings) {
  open(
      "Product code,Bureau of Meteorology station number,Year,Month,Day,Rainfall amount "
      "(millimetres),Period over which rainfall was measured (days),Quality\n"
      "P,070014,2010,12,30,0.5,1,Y\nP,070014,2010,12,31,7.0,2,Y\nP,070014,2011,01,01,,,\n");
  EXPECT_EQ(values(*table_, 5), "0.5 - - ");
  EXPECT_EQ(warnings_.messages().size(), 1U);
}

TEST_F(PublishedTableTest, the_format_says_what_the_user_does_not) {
  const PublishedFormat& format = open(by_year);
  const ReadingsOptions all = options_of(format, *table_, {});
  EXPECT_EQ(all.station_field, "ID");
  EXPECT_EQ(all.time_fields, std::vector<std::string>{"DATE"});
  EXPECT_EQ(all.value_field, "DATA_VALUE");
  EXPECT_EQ(all.from_unit->name(), "0.1mm");
  ReadingsOptions said;
  said.scale = 2;
  EXPECT_FALSE(options_of(format, *table_, said).from_unit);
}

TEST_F(PublishedTableTest, the_unit_of_an_order_is_asked_for) {
  const PublishedFormat& format = open("STATION,NAME,DATE,PRCP\nA,B,2020-01-01,1\n");
  EXPECT_FALSE(complaint_of([&] { options_of(format, *table_, {}); }).empty());
  ReadingsOptions said;
  said.scale = 25.4;
  EXPECT_EQ(options_of(format, *table_, said).value_field, "PRCP");
}

class MarkedTable : public PublishedTableTest {
 protected:
  std::string values_of(const std::string& rows) {
    auto csv = std::make_unique<CsvReader>(folder_.write("m.csv", "date,ind,rain\n" + rows));
    const PublishedFormat& format =
        *format_of_header(csv->header(), "Station Name: A\ndate,ind,rain\n");
    PublishedTable table(std::move(csv), format, {}, warnings_);
    return values(table, 2);
  }
};

TEST_F(MarkedTable, counts_values_by_the_publishers_key_and_tells_it) {
  EXPECT_EQ(values_of("1,0,0.1\n2,4,0.2\n3,6,9\n4,4,\n5,4,0.5\n6,2,0.0\n"), "0.1 0.2 0 - 0.5 0.0 ")
      << "6 is a trace";
  ASSERT_EQ(warnings_.notices().size(), 1U);
  EXPECT_EQ(warnings_.notices()[0].text.plain(),
            "values with another indicator (ind) than 0 count: 1 of '2' (a trace or a sum), 2 of "
            "'4' (estimated), 1 of '6' (an estimated trace, read as 0)");
  EXPECT_TRUE(warnings_.messages().empty());
}

TEST_F(MarkedTable, warns_of_marks_that_the_key_lacks) {
  EXPECT_EQ(values_of("1,-1,0.1\n2,4,0.2\n"), "0.1 0.2 ");
  ASSERT_EQ(warnings_.messages().size(), 1U);
  EXPECT_EQ(warnings_.messages()[0].text.plain(),
            "values with another indicator (ind) than 0 count: 1 of '-1', which the publisher's "
            "key lacks, 1 of '4' (estimated)");
}

}  // namespace
}  // namespace thiessen
