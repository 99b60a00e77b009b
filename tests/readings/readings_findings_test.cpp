#include "readings/readings_findings.h"

#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

class ReadingsFindingsTest : public testing::Test {
 protected:
  const std::vector<Station> listed = {{"A", {}}, {"B", {}}, {"C", {}}};
  const ReadingsStations stations{listed, {}};
  const ReadingGrammar grammar{{}, {}, DecimalMark::point};
  Warnings warnings;

  ReadingsFindings findings(bool ignore_unknown = false) {
    return {"r.csv", stations, ignore_unknown, warnings};
  }
  /// Takes note of a field as the readers do.
  void note(ReadingsFindings& findings, const std::string& field, std::uint32_t station,
            std::size_t line = 2) const {
    const Reading reading = grammar.read(field, false);
    if (findings.note(reading, StationIndex{station})) return;
    findings.note_oddity(reading, {line, StationIndex{station}}, field, grammar);
  }
  static Texts concluded(ReadingsFindings& findings) {
    return complaints_of([&] { findings.conclude(1); });
  }
  Texts warned() const { return sentences_of(warnings); }
};

TEST_F(ReadingsFindingsTest, says_nothing_of_amounts_and_gaps) {
  ReadingsFindings all = findings();
  for (const std::uint32_t station : {0U, 1U, 2U}) {
    note(all, "", station);
    note(all, "30000", station);
  }
  all.conclude(2);
  EXPECT_EQ(warned(), Texts{});
}

TEST_F(ReadingsFindingsTest, a_bad_reading_is_a_complaint_with_line_station_and_text) {
  ReadingsFindings bad = findings();
  note(bad, " -2 ", 1, 7);
  note(bad, "x", 0, 8);
  note(bad, "1e400", 2, 9);
  note(bad, "1,5", 2, 10);
  EXPECT_EQ(concluded(bad),
            (Texts{"r.csv:7: negative reading '-2' of station 'B' | missing = -2 takes it for a "
                   "gap, trace = -2 for 0",
                   "r.csv:8: reading 'x' of station 'A' is no number | missing = x takes it for a "
                   "gap, trace = x for 0",
                   "r.csv:9: reading '1e400' of station 'C' is outside the range of numbers",
                   "r.csv:10: reading '1,5' of station 'C' is no number | 'rainfall_decimal_comma' "
                   "reads 1,5 as 1.5"}));
  EXPECT_EQ(warned(), Texts{}) << "where there are complaints nothing else is told";
}

TEST_F(ReadingsFindingsTest, a_text_that_may_be_a_true_reading_is_never_called_a_gap) {
  ReadingsFindings bad = findings();
  note(bad, "1,234", 0, 2);
  note(bad, "1,234.5", 0, 3);
  note(bad, "0.2E", 0, 4);
  note(bad, "<0.2", 0, 5);
  note(bad, "0.3E", 0, 6);
  EXPECT_EQ(concluded(bad),
            (Texts{"r.csv:2: reading '1,234' of station 'A' could be 1.234 or 1234 | "
                   "'rainfall_decimal_comma' reads it as 1.234; where it is 1234, write it without "
                   "the comma",
                   "r.csv:3: reading '1,234.5' of station 'A' is no number | write it without what "
                   "parts its thousands",
                   "r.csv:4: reading '0.2E' of station 'A' is no number | write the number alone, "
                   "without what stands beside it",
                   "r.csv:5: reading '<0.2' of station 'A' is no number | missing = <0.2 takes it "
                   "for a gap, trace = <0.2 for 0",
                   "r.csv:6: reading '0.3E' of station 'A' is no number"}));
}

TEST_F(ReadingsFindingsTest, a_decimal_point_among_commas_has_the_hint_of_the_file_it_stands_in) {
  const ReadingGrammar commas({}, {}, DecimalMark::comma);
  ReadingsFindings said = findings();
  said.are_in("stations", true);
  said.note_oddity(commas.read("4.5", false), {2, StationIndex{0}}, "4.5", commas);
  EXPECT_EQ(concluded(said),
            (Texts{"r.csv:2: reading '4.5' of station 'A' has a decimal point, and numbers are "
                   "read with decimal commas | without 'stations_decimal_comma' or 'decimal_comma' "
                   "the decimal mark is found out"}));
  ReadingsFindings found = findings();
  found.note_oddity(commas.read("4.5", false), {2, StationIndex{0}}, "4.5", commas);
  EXPECT_TRUE(
      concluded(found).at(0).ends_with("| write all numbers of the file with one decimal mark"));
}

TEST_F(ReadingsFindingsTest, absurd_readings_are_one_warning_and_readings_all_the_same) {
  ReadingsFindings odd = findings();
  for (std::size_t line = 5; line < 8; ++line) note(odd, "30000.1", 1, line);
  note(odd, "1", 0);
  note(odd, "1", 2);
  odd.conclude(3);
  EXPECT_EQ(warned(), Texts{"r.csv:5: reading '30000.1' of station 'B' is more than falls anywhere "
                            "in a year, and so are 2 more"});
}

TEST_F(ReadingsFindingsTest, an_unknown_station_is_told_once_and_the_hint_once_for_all) {
  ReadingsFindings unknown = findings();
  for (const char* id : {"X", "X", "Y"})
    unknown.note_unknown(id, 4, std::string("no ") + id, "hint");
  EXPECT_EQ(concluded(unknown), (Texts{"r.csv:4: no X | hint", "r.csv:4: no Y"}));
}

TEST_F(ReadingsFindingsTest, unknown_stations_that_are_ignored_are_counted) {
  ReadingsFindings unknown = findings(true);
  for (const std::uint32_t station : {0U, 1U, 2U}) note(unknown, "1", station);
  for (int i = 0; i < 12; ++i) unknown.note_unknown("X" + std::to_string(i), 4, "", "");
  unknown.conclude(1);
  ASSERT_EQ(warned().size(), 1U);
  EXPECT_TRUE(warned()[0].starts_with("r.csv: 12 unknown stations are passed over: 'X0', 'X1', "));
  EXPECT_TRUE(warned()[0].ends_with("'X9' and 2 more"));
}

TEST_F(ReadingsFindingsTest, stations_that_never_report_are_told_where_there_are_steps) {
  ReadingsFindings silent = findings();
  note(silent, "0", 1);
  note(silent, "NA", 2);
  silent.conclude(1);
  EXPECT_EQ(warned(), Texts{"r.csv: 2 stations have no readings: 'A', 'C'"});
  ReadingsFindings none = findings();
  none.conclude(0);
  EXPECT_EQ(warned().size(), 1U) << "without a step nobody is silent";
}

TEST_F(ReadingsFindingsTest, places_are_those_of_the_file_that_is_read) {
  ReadingsFindings several = findings();
  several.note_empty_time(3);
  several.now_in("s.csv");
  several.note_empty_time(4);
  several.complaints().add(several.time_twice("x", 9, 5));
  EXPECT_EQ(concluded(several), (Texts{"r.csv:3: the time is empty", "s.csv:4: the time is empty",
                                       "s.csv:9: time 'x' is already in line 5 | each time stands "
                                       "once: keep the row that is meant"}));
}

}  // namespace
}  // namespace thiessen
