#include "cli/terminal/messages.h"

#include <gtest/gtest.h>

namespace thiessen::cli {
namespace {

/// What is printed on the standard error.
template <typename Print>
std::string printed(Print print) {
  testing::internal::CaptureStderr();
  print();
  return testing::internal::GetCapturedStderr();
}

TEST(Messages, settings_are_options_and_inputs_are_arguments) {
  EXPECT_EQ(shown("see " + setting("time_field") + " of " + input("stations")),
            "see --time-field of STATIONS");
  EXPECT_EQ(shown(setting("metric", "planar")), "--metric planar");
}

// As an argument of its own -99 would be taken for an option.
TEST(Messages, a_value_that_begins_like_an_option_stands_behind_an_equals_sign) {
  EXPECT_EQ(shown(setting("missing", "-99")), "--missing=-99");
}

TEST(Messages, a_value_is_written_as_a_shell_takes_it) {
  EXPECT_EQ(shown(setting("missing", "<0.2")), "--missing '<0.2'");
  EXPECT_EQ(shown(setting("missing", "no data")), "--missing 'no data'");
  EXPECT_EQ(shown(setting("missing", "-9 x")), "--missing='-9 x'");
  EXPECT_EQ(shown(setting("missing", "it's $1")), "--missing \"it's \\$1\"");
  EXPECT_EQ(shown(setting("missing", "*")), "--missing '*'");
  EXPECT_EQ(shown(setting("rainfall_where", "\"time\"<>'Total'")),
            R"(--rainfall-where "\"time\"<>'Total'")");
  EXPECT_EQ(shown(setting("time_format", "%d/%m/%Y")), "--time-format %d/%m/%Y");
}

TEST(Messages, a_text_of_a_file_is_shown_and_never_taken_for_a_setting) {
  EXPECT_EQ(shown(Wording("a\x1b[2J 'time_field'")), "a\\x1b[2J 'time_field'");
}

TEST(Messages, have_their_place_and_a_hint_on_a_line_of_its_own) {
  EXPECT_EQ(printed([] {
              print("error: ", Message{"s.csv", 7, "is odd", "mend it"});
            }),
            "error: s.csv:7: is odd\nhint: mend it\n");
  EXPECT_EQ(printed([] { print("warning: ", Message{"", 0, "is odd", ""}); }), "warning: is odd\n");
}

TEST(Messages, of_an_error_are_all_that_it_lists_and_the_number_of_the_others) {
  const Error error({{"s.csv", 2, "one", ""}, {"s.csv", 3, "two", ""}}, 40);
  EXPECT_EQ(printed([&] { print("error: ", error); }),
            "error: s.csv:2: one\nerror: s.csv:3: two\nerror: and 40 more\n");
}

}  // namespace
}  // namespace thiessen::cli
