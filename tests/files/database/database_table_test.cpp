#include "files/database/database_table.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(DatabaseTable, columns_have_the_types_of_their_names) {
  EXPECT_EQ(sql_columns({"time", "rainfall", "gauges", "geom", "a\"b"}, 4326),
            "\"time\" text, \"rainfall\" double precision, \"gauges\" bigint, "
            "\"geom\" geometry(MultiPolygon, 4326), \"a\"\"b\" text");
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
