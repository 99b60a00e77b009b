// What fuzzers found in base/, numbered on from room to room.
#include <gtest/gtest.h>

#include "base/iso_time.h"
#include "base/secrets.h"

namespace thiessen {
namespace {

TEST(Secrets, finding_7_a_password_ends_before_blanks_and_within_its_quotes) {
  EXPECT_EQ(without_secrets("no user for secret", "PG:host=a password=secret "), "no user for ***");
  EXPECT_EQ(without_secrets("no user for my secret", "PG:password='my secret' host=a"),
            "no user for ***");
  EXPECT_EQ(without_password("PG:host=a password=secret "), "PG:host=a password=*** ");
}

TEST(IsoTime, finding_8_a_zone_brings_a_time_beyond_the_years_that_are_written) {
  const auto in_utc = [](const char* text) {
    return time_text(moment_seconds(parse_iso_time(text).time), TimePrecision::instant);
  };
  EXPECT_EQ(in_utc("9999-12-31T20:00-14:00"), "10000-01-01T10:00");
  EXPECT_EQ(in_utc("0000-01-01T10:00+14:00"), "-0001-12-31T20:00");
  EXPECT_EQ(in_utc("0000-01-01T10:00"), "0000-01-01T10:00");
}

}  // namespace
}  // namespace thiessen
