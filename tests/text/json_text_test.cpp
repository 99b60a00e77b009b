#include "text/json_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/utf8.h"
#include "text/json_scanner.h"
#include "text/text_bytes.h"

namespace thiessen {
namespace {

std::string json(std::string_view text) {
  std::string out;
  append_json_string(out, text);
  return out;
}

std::string read_back(const std::string& text) {
  TextBytes bytes(text);
  JsonScanner scanner("f.json", bytes);
  std::string read = scanner.string();
  scanner.require_end();
  return read;
}

TEST(JsonText, leaves_plain_text_of_any_script_as_it_is) {
  EXPECT_EQ(json(""), "\"\"");
  EXPECT_EQ(json("a/b 'c' > & \xE9\x9B\xA8 \xF0\x9F\x98\x80"),
            "\"a/b 'c' > & \xE9\x9B\xA8 \xF0\x9F\x98\x80\"");
}

TEST(JsonText, escapes_what_json_requires) {
  EXPECT_EQ(json("a\"b\\c"), R"("a\"b\\c")");
  EXPECT_EQ(json(std::string_view("\0\x1f\n\x7f", 4)), R"("\u0000\u001f\u000a\u007f")");
}

// In a page's script `</script>` would end the script, and these two end a line of JavaScript.
TEST(JsonText, escapes_what_a_page_would_take_for_its_own) {
  EXPECT_EQ(json("</script>"), R"("\u003c/script>")");
  EXPECT_EQ(json("\xE2\x80\xA8\xE2\x80\xA9"), R"("\u2028\u2029")");
  EXPECT_EQ(json("\xE2\x80\xA7\xE2\x80\xAA"), "\"\xE2\x80\xA7\xE2\x80\xAA\"") << "their neighbours";
}

TEST(JsonText, bytes_that_are_not_utf8_become_the_replacement_character_one_by_one) {
  EXPECT_EQ(json("a\xFF\x80z"), R"("a\ufffd\ufffdz")");
  EXPECT_EQ(json("\xE2\x80"), R"("\ufffd\ufffd")");
  EXPECT_EQ(json("\xC0<"), R"("\ufffd\u003c")");
}

TEST(JsonText, appends_to_what_is_there) {
  std::string out = "{";
  append_json_string(out, "a");
  EXPECT_EQ(out, "{\"a\"");
}

TEST(JsonText, law_1_text_comes_back_and_the_output_is_safe_whatever_the_bytes) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const std::string pieces = std::string("\"\\/<>&ab\n\x1b\x7f\xE2\x80\xA8\xA9\xFF\xC3\xA9", 18);
  for (int round = 0; round < 20'000; ++round) {
    std::string text;
    for (auto n = random() % 8; n > 0; --n) text += pieces[random() % pieces.size()];
    const std::string out = json(text);
    ASSERT_EQ(find_invalid_utf8(out), std::nullopt);
    ASSERT_TRUE(std::none_of(out.begin(), out.end(), [](char c) {
      return c == '<' || c == '\x7f' || (c >= 0 && c < ' ');
    })) << out;
    const std::string read = read_back(out);
    if (!find_invalid_utf8(text)) {
      ASSERT_EQ(read, text);
    }
  }
}

}  // namespace
}  // namespace thiessen
