// What fuzzers found in text/, numbered on from room to room.
#include <gtest/gtest.h>

#include <string>

#include "base/complaints.h"
#include "fuzzers/memory_pipe.h"
#include "text/csv_reader.h"
#include "text/csv_writer.h"
#include "text/geojson_audit.h"
#include "text/text_bytes.h"

namespace thiessen {
namespace {

GeoJsonFindings audit(const std::string& text) {
  TextBytes bytes(text);
  return audit_geojson("b.geojson", bytes);
}

std::string complaint(const std::string& text) {
  return complaint_of([&] { audit(text); });
}

std::string polygon(const std::string& coordinates) {
  return R"({"type":"Polygon","coordinates":)" + coordinates + "}";
}

TEST(GeoJsonAudit, finding_1_counts_bytes_from_0) {
  EXPECT_EQ(complaint("{\"name\":\"a\xFF\"}"), "b.geojson:1: not whole JSON: not UTF-8 at byte 10");
  EXPECT_EQ(complaint("\xEF\xBB\xBF{\"\xE4\xB8\"}"),
            "b.geojson:1: not whole JSON: not UTF-8 at byte 5");
}

TEST(GeoJsonAudit, finding_2_calls_a_full_width_digit_utf8) {
  EXPECT_EQ(complaint("\xEF\xBC\x91"),
            "b.geojson:1: not whole JSON: a value is expected, not '\\xef'");
}

TEST(GeoJsonAudit, finding_3_wants_numbers_in_every_position) {
  const std::string none = ": a position has two numbers, not none";
  const std::string file = "b.geojson: ";
  EXPECT_EQ(complaint(polygon("[[[0,0],[],[1,1],[0,0]]]")), file + "coordinates[0][1]" + none);
  EXPECT_EQ(complaint(polygon("[[[0,0],[1,0],[1,1],[0,0]],[[]]]")),
            file + "coordinates[1][0]" + none);
  EXPECT_EQ(complaint(polygon("[[[0,0],[1,0],[1,1],[0,0]],[[[]]]]")),
            file + "coordinates are not nested as those of a Polygon");
  // No ring and no polygon are no position: they are empty, and said to be where they are read.
  EXPECT_EQ(audit(polygon("[]")).features, 1U);
  EXPECT_EQ(audit(polygon("[[[0,0],[1,0],[1,1],[0,0]],[]]")).features, 1U);
}

TEST(CsvWriter, finding_5_quotes_a_byte_order_mark) {
  std::string row;
  append_csv_field(row, "\xEF\xBB\xBFid");
  EXPECT_EQ(row, "\"\xEF\xBB\xBFid\"");
}

// The piece that is read after a carriage return, to see whether a line feed follows, is no text.
TEST(CsvReader, finding_9_counts_a_line_end_once_where_two_pieces_meet) {
  const fuzzers::MemoryPipe pipe("a;b/\rc\xC9\xFC", 5);
  const auto read = [&] {
    CsvReader reader(pipe.name(), {';'});
    Row row;
    reader.next(row);
  };
  EXPECT_EQ(complaint_of(read), pipe.name() + ":2: not UTF-8 at byte 6 | save the file as UTF-8");
}

// A blank line ends in a CR, behind which a piece ends: the LF that follows is part of that line's
// end.
TEST(CsvReader, finding_12_counts_the_end_of_a_blank_line_once_where_two_pieces_meet) {
  const fuzzers::MemoryPipe pipe("x\ny\n\r\nz\n", 5);
  CsvReader reader(pipe.name(), {','});
  Row row;
  ASSERT_TRUE(reader.next(row));
  EXPECT_EQ(row.line, 2U);
  ASSERT_TRUE(reader.next(row));
  EXPECT_EQ(row.line, 4U);
}

// RFC 7946, 7.1: a Feature must not have features.
TEST(GeoJsonAudit, finding_11_refuses_features_of_a_feature) {
  EXPECT_EQ(complaint(R"({"type":"Feature","geometry":null,"features":[]})"),
            "b.geojson: type is 'Feature', not FeatureCollection");
}

}  // namespace
}  // namespace thiessen
