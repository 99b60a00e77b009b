#include "readings/stations/heard_stations.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

/// A table in memory that counts the rows that are read.
class CountingTable : public Table {
 public:
  CountingTable(std::vector<std::string> header, std::vector<std::vector<std::string>> rows)
      : header_(std::move(header)), rows_(std::move(rows)) {}

  const std::string& file() const override { return file_; }
  const std::vector<std::string>& header() const override { return header_; }
  bool next(Row& row) override {
    if (read_ == rows_.size()) return false;
    row.fields.assign(rows_[read_].begin(), rows_[read_].end());
    row.line = ++read_;
    return true;
  }
  std::size_t rows_read() const { return read_; }

 private:
  std::string file_ = "r.csv";
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
  std::size_t read_ = 0;
};

class Ears {
 public:
  explicit Ears(std::vector<std::string> passed_over = {}) : passed_over_(std::move(passed_over)) {}

  ReadingsOptions options;

  std::string heard_in(Table& table) {
    return heard([&](HeardStations& all) { all.look_through(table, options); });
  }
  std::string heard_in_csv(const std::string& text) {
    const TemporaryFolder folder;
    CsvReader table(folder.write("r.csv", text));
    return heard_in(table);
  }
  std::string heard_in_dly(const std::string& text, bool keep_flagged = false) {
    const TemporaryFolder folder;
    const std::string file = folder.write("r.dly", text);
    return heard([&](HeardStations& all) { all.look_through_dly({file}, keep_flagged); });
  }

 private:
  /// The ids that have been heard, in the order of the stations.
  template <typename Look>
  std::string heard(const Look& look) {
    const std::vector<Station> stations{{"A", {}}, {"B", {}}, {"C", {}}};
    const ReadingsStations known(stations, passed_over_);
    HeardStations all(known);
    look(all);
    std::string ids;
    for (std::uint32_t s = 0; s < stations.size(); ++s) {
      if (all.heard()[StationIndex{s}]) ids += stations[s].id;
    }
    EXPECT_EQ(all.all(), ids == "ABC");
    return ids;
  }

  std::vector<std::string> passed_over_;
};

TEST(HeardStations, of_a_wide_table_have_a_field_that_is_a_reading) {
  EXPECT_EQ(Ears().heard_in_csv("time,A,B,C\n1,,-,NA\n2,,0,-999\n"), "B");
  EXPECT_EQ(Ears().heard_in_csv("time,C,A\n1,,2\n2,5,\n"), "AC");
  EXPECT_EQ(Ears().heard_in_csv("time,A,Z\n1,,2\n"), "") << "Z is no station";
}

TEST(HeardStations, of_a_long_table_have_a_row_with_a_reading) {
  EXPECT_EQ(Ears().heard_in_csv("time,station,rain\n1,A,\n1,C,3\n2,B,null\n2,C,\n"), "C");
  EXPECT_EQ(Ears().heard_in_csv("station,time,rain\nB,1,0\nZ,1,4\nA,2,1\n"), "AB");
}

TEST(HeardStations, know_the_texts_that_mean_none_and_those_that_mean_zero) {
  Ears ears;
  ears.options.missing = {"?", "7"};
  ears.options.trace = {"T", "-1"};
  EXPECT_EQ(ears.heard_in_csv("time,A,B,C\n1,?,T,7.0\n"), "B");
  EXPECT_EQ(ears.heard_in_csv("time,station,rain\n1,A,7\n1,C,-1\n"), "C");
}

// Their stations have to be read once more, so that what is wrong is told.
TEST(HeardStations, have_readings_that_are_wrong_too) {
  EXPECT_EQ(Ears().heard_in_csv("time,A,B,C\n1,-5,x,\n"), "AB");
  EXPECT_EQ(Ears().heard_in_csv("time,station,rain\n1,C,1e999\n"), "C");
}

TEST(HeardStations, are_none_of_those_passed_over) {
  EXPECT_EQ(Ears({"Z"}).heard_in_csv("time,A,Z\n1,3,2\n"), "A");
}

TEST(HeardStations, end_the_look_as_soon_as_all_are_heard) {
  CountingTable wide({"time", "A", "B", "C"},
                     {{"1", "1", "", "1"}, {"2", "", "1", ""}, {"3", "1", "1", "1"}});
  EXPECT_EQ(Ears().heard_in(wide), "ABC");
  EXPECT_EQ(wide.rows_read(), 2u);
  CountingTable without({"time", "A", "B"}, {{"1", "1", "1"}, {"2", "1", "1"}});
  EXPECT_EQ(Ears().heard_in(without), "AB") << "C has no column and cannot be heard";
  EXPECT_EQ(without.rows_read(), 1u);
  CountingTable tall({"time", "station", "rain"},
                     {{"1", "A", "1"}, {"1", "B", "1"}, {"1", "C", "1"}, {"2", "A", "1"}});
  EXPECT_EQ(Ears().heard_in(tall), "ABC");
  EXPECT_EQ(tall.rows_read(), 3u);
}

TEST(HeardStations, of_dly_files_have_a_value_of_rain_that_passed_the_checks) {
  const auto record = [](const std::string& id, const std::string& element,
                         const std::string& first_day) {
    std::string line = id + std::string(11 - id.size(), ' ') + "201309" + element + first_day;
    while (line.size() < 269) line += "-9999   ";
    return line + "\n";
  };
  const std::string text = record("A", "PRCP", "   12  7") + record("B", "PRCP", "-9999   ") +
                           record("B", "TMAX", "  120  7") + record("C", "PRCP", "   12 X7");
  EXPECT_EQ(Ears().heard_in_dly(text), "A");
  EXPECT_EQ(Ears().heard_in_dly(text, true), "AC");
}

}  // namespace
}  // namespace thiessen
