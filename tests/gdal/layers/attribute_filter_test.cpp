#include "gdal/layers/attribute_filter.h"

#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

const std::vector<FieldName> fields = {
    {"name", FieldType::text}, {"elev", FieldType::integer}, {"slope", FieldType::real}};

bool keeps(const std::string& where, std::vector<std::string_view> texts) {
  return AttributeFilter(where, "stations_where", "s.csv", fields).keeps(Row{2, std::move(texts)});
}

TEST(AttributeFilter, compares_numbers_as_numbers_and_texts_as_texts) {
  EXPECT_TRUE(keeps("elev > 900", {"A", "1000", "0.5"}));
  EXPECT_FALSE(keeps("elev > 900", {"A", "90", "0.5"}));
  EXPECT_TRUE(keeps("slope < 0.51 AND name LIKE 'A%'", {"Abc", "1", "0.5"}));
  EXPECT_TRUE(keeps("name IN ('007', 'B')", {"007", "1", "0.5"}));
}

TEST(AttributeFilter, an_empty_text_is_null) {
  EXPECT_TRUE(keeps("elev IS NULL", {"A", "", "1"}));
  EXPECT_FALSE(keeps("elev > 0", {"A", "", "1"}));
  EXPECT_TRUE(keeps("name IS NULL", {"", "1", "1"}));
}

TEST(AttributeFilter, names_the_option_and_the_fault) {
  EXPECT_TRUE(
      complaint_of([] { keeps("elev >", {}); }).starts_with("s.csv: stations_where = 'elev >': "));
  EXPECT_TRUE(contains(complaint_of([] { keeps("height > 3", {}); }), "height"));
  EXPECT_TRUE(complaint_of([] {
                keeps("height > 3", {});
              }).ends_with("; the fields are 'name', 'elev', 'slope'"));
  EXPECT_FALSE(contains(complaint_of([] { keeps("elev >", {}); }), "the fields are"));
  EXPECT_TRUE(contains(complaint_of([] { keeps("1; DROP TABLE x", {}); }), "stations_where"));
}

}  // namespace
}  // namespace thiessen
