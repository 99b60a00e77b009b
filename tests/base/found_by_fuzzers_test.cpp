// What fuzzers found in base/, numbered on from room to room.
#include <gtest/gtest.h>

#include "base/secrets.h"

namespace thiessen {
namespace {

TEST(Secrets, finding_7_a_password_ends_before_blanks_and_within_its_quotes) {
  EXPECT_EQ(without_secrets("no user for secret", "PG:host=a password=secret "), "no user for ***");
  EXPECT_EQ(without_secrets("no user for my secret", "PG:password='my secret' host=a"),
            "no user for ***");
  EXPECT_EQ(without_password("PG:host=a password=secret "), "PG:host=a password=*** ");
}

}  // namespace
}  // namespace thiessen
