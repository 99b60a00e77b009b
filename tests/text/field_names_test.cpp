#include "text/field_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "base/complaints.h"

namespace thiessen {
namespace {

using Header = std::vector<std::string>;

std::optional<std::size_t> found(const Header& header, const std::vector<std::string_view>& names) {
  return find_field(header, names);
}

FieldType type_of(const std::vector<std::string>& texts) {
  FieldTypeGuess guess;
  for (const std::string& text : texts) guess.see(text);
  return guess.type();
}

TEST(FindField, takes_the_first_of_the_names_whatever_the_order_of_the_fields) {
  EXPECT_EQ(found({"name", "x", "id"}, {"id", "name"}), 2U);
  EXPECT_EQ(found({"name", "x", "id"}, {"code", "name"}), 0U);
  EXPECT_EQ(found({"a", "A"}, {"a"}), 0U);
}

TEST(FindField, passes_over_case_and_what_parts_words_and_nothing_else) {
  for (const char* name : {"STATION_ID", " Station ID\t", "station-id", "station.id"})
    EXPECT_EQ(found({"x", name}, {"station_id"}), 1U) << name;
  for (const char* name : {"stationid", "station_i", "station__id", "id"})
    EXPECT_EQ(found({name}, {"station_id"}), std::nullopt) << name;
  EXPECT_EQ(found({}, {"lon"}), std::nullopt);
}

TEST(SameName, knows_the_capitals_of_latin_letters_with_accents) {
  EXPECT_TRUE(same_name("ESTACI\xC3\x93N", "estaci\xC3\xB3n"));
  EXPECT_TRUE(same_name("L\xC3\x84NGE", "l\xC3\xA4nge"));
  EXPECT_FALSE(same_name("\xC3\x97", "\xC3\xB7")) << "the signs of times and of division";
  EXPECT_FALSE(same_name("estacion", "estaci\xC3\xB3n"));
}

TEST(RequireField, prefers_the_very_name_to_one_that_differs_in_case) {
  const auto required = [](const Header& header, const std::string& name) {
    return require_field(header, name, setting("x"), "s.csv", 3);
  };
  EXPECT_EQ(required({"east", "EAST"}, "EAST"), 1U);
  EXPECT_EQ(required({"east", "EAST"}, "East"), 0U);
  EXPECT_EQ(complaint_of([&] {
              required({"a", "b"}, "c");
            }),
            "s.csv:3: 'x': no field 'c'; found 'a', 'b'");
  EXPECT_EQ(complaint_of([&] { required({}, "c"); }), "s.csv:3: 'x': no field 'c'; found none");
}

TEST(Listed, names_twenty_and_counts_the_others) {
  const std::vector<std::string_view> bare = {"lon", "long"};
  EXPECT_EQ(listed(bare), "lon, long");
  Header names(20, "n");
  EXPECT_FALSE(contains(listed(names), "more"));
  names.emplace_back("last");
  names.emplace_back("last");
  EXPECT_TRUE(listed(names).ends_with("'n' and 2 more"));
}

TEST(FieldTypeGuess, numbers_are_those_that_read_back_as_written) {
  for (const char* text : {"0", "5", "-5", "100", "999999999999999999"})
    EXPECT_EQ(type_of({text}), FieldType::integer) << text;
  for (const char* text : {"0.5", "-0.5", ".5", "1e3", "1E-3", "0.0"})
    EXPECT_EQ(type_of({text}), FieldType::real) << text;
  for (const char* text : {"007", "-007", "00.5", "+5", "+0.5", "1,5", "12345678901234567890",
                           "NaN", "inf", "0x10", " 1", "-", "1e999", "2013-08-01"})
    EXPECT_EQ(type_of({text}), FieldType::text) << text;
}

TEST(FieldTypeGuess, is_text_where_nothing_is_seen) {
  EXPECT_EQ(type_of({}), FieldType::text);
  EXPECT_EQ(type_of({"", ""}), FieldType::text);
  EXPECT_EQ(type_of({"", "1"}), FieldType::integer) << "an empty text is no value";
}

TEST(FieldTypeGuess, law_1_is_the_widest_type_in_any_order) {
  const std::vector<std::pair<std::string, int>> texts = {
      {"", -1}, {"1", 0}, {"-30", 0}, {"1.5", 1}, {"1e3", 1}, {"007", 2}, {"a", 2}};
  const FieldType types[] = {FieldType::integer, FieldType::real, FieldType::text};
  for (const auto& [a, width_a] : texts) {
    for (const auto& [b, width_b] : texts) {
      for (const auto& [c, width_c] : texts) {
        const int widest = std::max({width_a, width_b, width_c});
        EXPECT_EQ(type_of({a, b, c}), widest < 0 ? FieldType::text : types[widest])
            << a << ' ' << b << ' ' << c;
      }
    }
  }
}

}  // namespace
}  // namespace thiessen
