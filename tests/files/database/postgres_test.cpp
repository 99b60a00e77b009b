#include "files/database/postgres.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(Postgres, a_connection_begins_with_PG) {
  EXPECT_TRUE(is_database("PG:dbname=rain"));
  EXPECT_TRUE(is_database("pg:postgresql://localhost/rain"));
  EXPECT_FALSE(is_database("PG.csv"));
  EXPECT_FALSE(is_database("PG"));
  EXPECT_FALSE(is_database(""));
}

TEST(Postgres, words_of_GDAL_alone_are_not_for_libpq) {
  const LibpqConnection found = libpq_connection(
      "PG:host=a  dbname='my rain' active_schema=results schemas=a,b tables=x(geom) "
      "password='it\\'s'");
  EXPECT_EQ(found.words, "host=a dbname='my rain' password='it\\'s'");
  EXPECT_EQ(found.schema, "results");
}

TEST(Postgres, a_URI_goes_over_as_it_is) {
  EXPECT_EQ(libpq_connection("PG:postgresql://u:tables=@h/d").words, "postgresql://u:tables=@h/d");
}

}  // namespace
}  // namespace thiessen
