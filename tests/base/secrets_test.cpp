#include "base/secrets.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace thiessen {
namespace {

TEST(Secrets, a_connection_loses_its_password_and_nothing_else) {
  EXPECT_EQ(without_password("PG:host=a password=secret user=b"), "PG:host=a password=*** user=b");
  EXPECT_EQ(without_password("PG:password=my own secret user=b"), "PG:password=*** user=b");
  EXPECT_EQ(without_password("PG:PASSWORD = 'my \\' secret' user=b"), "PG:PASSWORD = *** user=b");
  EXPECT_EQ(without_password("PG:postgresql://u:s@cret@host/x"), "PG:postgresql://u:***@host/x");
  // libpq passes over blanks behind the sign.
  EXPECT_EQ(without_password("PG:host=a password= b user=c"), "PG:host=a password= *** user=c");
  EXPECT_EQ(without_password("PG:passwords dbname=x password=a password=b"),
            "PG:passwords dbname=x password=*** password=***");
}

TEST(Secrets, what_has_no_password_stays_as_it_is) {
  for (const char* text : {"", "stations.csv", "PG:dbname=rain", "http://host:80/a", "password",
                           "a password, or none", "/vsizip/a.zip"}) {
    EXPECT_EQ(without_password(text), text);
    EXPECT_EQ(without_passwords(text), text);
  }
}

TEST(Secrets, a_sentence_goes_on_after_the_password) {
  EXPECT_EQ(without_passwords("PG:host=a password=secret: cannot be read"),
            "PG:host=a password=***: cannot be read");
  EXPECT_EQ(without_passwords("not 'PG:host=a password=secret', but"),
            "not 'PG:host=a password=***', but");
}

TEST(Secrets, a_message_has_none) {
  const Message message{"PG:host=a password=my secret", 0, "no stations", {}};
  EXPECT_EQ(message.sentence(), "PG:host=a password=***: no stations");
  EXPECT_EQ(message.placed().plain(), "PG:host=a password=***: no stations");
}

TEST(Secrets, what_a_library_repeats_of_a_password_is_blotted_out) {
  const char* connection = "PG:host=a password=my secret user=b";
  EXPECT_EQ(without_secrets("missing \"=\" after \"secret\" in string", connection),
            "missing \"=\" after \"***\" in string");
  EXPECT_EQ(without_secrets("cannot log in by my secret", connection), "cannot log in by ***");
}

}  // namespace
}  // namespace thiessen
