#include "files/database/database_table.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(DatabaseTable, columns_have_the_types_of_their_names) {
  EXPECT_EQ(sql_columns({"time", "rainfall", "gauges", "geom", "a\"b"}, 4326),
            "\"time\" text, \"rainfall\" double precision, \"gauges\" bigint, "
            "\"geom\" geometry(MultiPolygon, 4326), \"a\"\"b\" text");
}

TEST(DatabaseTable, columns_of_others_are_text_whatever_their_names) {
  EXPECT_EQ(sql_columns({"station", "weight", "gauges", "area", "geom"}, 0, 2),
            "\"station\" text, \"weight\" double precision, \"gauges\" text, \"area\" text, "
            "\"geom\" geometry(MultiPolygon, 0)");
}

TEST(DatabaseTable, a_comment_of_another_form_is_no_mark) {
  EXPECT_TRUE(is_mark("thiessen 0.1.0; metric: geodesic; tolerance: 0.1; method: thiessen"));
  EXPECT_TRUE(is_mark("thiessen 12.0.33; metric: planar"));
  for (const char* comment :
       {"", "thiessen", "thiessen polygons drawn by hand, 1998", "thiessen 0.1.0",
        "thiessen 0.1; metric: planar", "thiessen 0.1.0: my notes", "thiessen 1.2.; metric: planar",
        "Thiessen 0.1.0; metric: planar", "of thiessen 0.1.0; metric: planar"})
    EXPECT_FALSE(is_mark(comment)) << comment;
}

TEST(DatabaseTable, a_name_that_would_be_cut_is_refused_before_anything_is_asked) {
  const auto refusal = [](const std::string& table) {
    try {
      const DatabaseTable made({"PG:host=/nowhere dbname=rain", table, true});
    } catch (const Error& error) {
      return error.messages().front().text.plain();
    }
    return std::string();
  };
  const std::string fits(63, 'a');
  EXPECT_NE(refusal(fits + "." + fits).find("cannot be reached"), std::string::npos);
  EXPECT_TRUE(
      refusal(fits + "b")
          .starts_with("the name of the table has 64 bytes, and PostgreSQL takes 63: 'aaa"));
  EXPECT_TRUE(refusal("s." + fits + "b").starts_with("the name of the table has 64 bytes"));
  EXPECT_TRUE(refusal(fits + "b.t").starts_with("the name of the schema has 64 bytes"));
  // Bytes count, and no letters: 32 of two bytes each.
  std::string letters;
  for (int i = 0; i < 32; ++i) letters += "\u00e9";
  EXPECT_TRUE(refusal(letters).starts_with("the name of the table has 64 bytes"));
}

TEST(DatabaseTable, a_database_that_is_not_there_is_an_error_without_its_password) {
  try {
    const DatabaseTable table({"PG:host=/nowhere dbname=rain password=sesame", "cells", false});
    FAIL();
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("cannot be reached"), std::string::npos) << text;
    EXPECT_EQ(text.find("sesame"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace thiessen
