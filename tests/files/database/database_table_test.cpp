#include "files/database/database_table.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(DatabaseTable, AConnectionBeginsWithPg) {
  EXPECT_TRUE(is_database("PG:dbname=rain"));
  EXPECT_TRUE(is_database("pg:postgresql://localhost/rain"));
  EXPECT_FALSE(is_database("PG.csv"));
  EXPECT_FALSE(is_database("PG"));
  EXPECT_FALSE(is_database(""));
}

TEST(DatabaseTable, WordsOfGdalAloneAreNotForLibpq) {
  const LibpqConnection found = libpq_connection(
      "PG:host=a  dbname='my rain' active_schema=results schemas=a,b tables=x(geom) "
      "password='it\\'s'");
  EXPECT_EQ(found.words, "host=a dbname='my rain' password='it\\'s'");
  EXPECT_EQ(found.schema, "results");
}

TEST(DatabaseTable, AUriGoesOverAsItIs) {
  EXPECT_EQ(libpq_connection("PG:postgresql://u:tables=@h/d").words, "postgresql://u:tables=@h/d");
}

TEST(DatabaseTable, ColumnsHaveTheTypesOfTheirNames) {
  EXPECT_EQ(sql_columns({"time", "rainfall", "gauges", "geom", "a\"b"}, 4326),
            "\"time\" text, \"rainfall\" double precision, \"gauges\" bigint, "
            "\"geom\" geometry(MultiPolygon, 4326), \"a\"\"b\" text");
}

TEST(DatabaseTable, ADatabaseThatIsNotThereIsAnErrorWithoutItsPassword) {
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
