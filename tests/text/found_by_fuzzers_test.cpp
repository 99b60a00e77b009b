// What fuzzers found in text/, numbered on from room to room.
#include <gtest/gtest.h>

#include <string>

#include "base/complaints.h"
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

TEST(GeoJsonAudit, finding_1_counts_bytes_from_0) {
  EXPECT_EQ(complaint("{\"name\":\"a\xFF\"}"), "b.geojson:1: not whole JSON: not UTF-8 at byte 10");
  EXPECT_EQ(complaint("\xEF\xBB\xBF{\"\xE4\xB8\"}"),
            "b.geojson:1: not whole JSON: not UTF-8 at byte 5");
}

TEST(GeoJsonAudit, finding_2_calls_a_full_width_digit_utf8) {
  EXPECT_EQ(complaint("\xEF\xBC\x91"),
            "b.geojson:1: not whole JSON: a value is expected, not '\\xef'");
}

}  // namespace
}  // namespace thiessen
