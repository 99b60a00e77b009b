#include "text/json_scanner.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/complaints.h"
#include "text/text_bytes.h"

namespace thiessen {
namespace {

using Kind = JsonScanner::Kind;

/// What the call makes of the text, whose bytes come in pieces of this size.
template <typename Call>
auto scanned(const std::string& text, Call call, std::size_t piece = 65536) {
  TextBytes bytes(text, piece);
  JsonScanner scanner("f.json", bytes);
  return call(scanner);
}

std::string text_of(const std::string& json, std::size_t piece = 65536) {
  return scanned(
      json, [](JsonScanner& scanner) { return scanner.string(); }, piece);
}

std::string number_of(const std::string& json) {
  return scanned(json, [](JsonScanner& scanner) {
    std::string number = scanner.number();
    scanner.require_end();
    return number;
  });
}

std::string fault_of_text(const std::string& json) {
  return complaint_of([&] { text_of(json); });
}

TEST(JsonScanner, tells_the_kind_of_a_value_by_its_first_byte) {
  const std::pair<const char*, Kind> kinds[] = {
      {" {", Kind::object}, {"\n[", Kind::array}, {"\t\"", Kind::string}, {"\r-", Kind::number},
      {"9", Kind::number},  {"n", Kind::literal}, {"N", Kind::literal},   {" ", Kind::end}};
  for (const auto& [text, kind] : kinds)
    EXPECT_EQ(scanned(text, [](JsonScanner& scanner) { return scanner.peek(); }), kind) << text;
  EXPECT_EQ(complaint_of([] { scanned("\n]", [](JsonScanner& s) { return s.peek(); }); }),
            "f.json:2: not whole JSON: a value is expected, not ']'");
}

TEST(JsonScanner, walks_through_objects_and_arrays) {
  scanned(R"( { "a" : [ 1 , 2 ] , "b" : {} } )", [](JsonScanner& scanner) {
    EXPECT_TRUE(scanner.open('{', '}'));
    EXPECT_EQ(scanner.string(), "a");
    scanner.colon();
    EXPECT_TRUE(scanner.open('[', ']'));
    EXPECT_EQ(scanner.number(), "1");
    EXPECT_TRUE(scanner.more(']'));
    EXPECT_EQ(scanner.number(), "2");
    EXPECT_FALSE(scanner.more(']'));
    EXPECT_TRUE(scanner.more('}'));
    EXPECT_EQ(scanner.string(), "b");
    scanner.colon();
    EXPECT_FALSE(scanner.open('{', '}'));
    EXPECT_FALSE(scanner.more('}'));
    scanner.require_end();
    return 0;
  });
}

// RFC 8259, section 6.
TEST(JsonScanner, numbers_are_those_of_the_grammar) {
  for (const char* text : {"0", "-0", "10", "0.5", "-1.25", "1e5", "1E+05", "1e-999", "2.0e0"})
    EXPECT_EQ(number_of(text), text);
  for (const char* text : {"01", "-", "+1", "1.", ".5", "1e", "1e+", "--1", "1-2", "1.2.3", "-01"})
    EXPECT_THROW(number_of(text), Error) << text;
  EXPECT_TRUE(contains(complaint_of([] { number_of(std::string(5000, '1')); }), "4096"));
}

TEST(JsonScanner, escapes_become_their_characters_in_utf8) {
  EXPECT_EQ(text_of(R"("\"\\\/\b\f\n\r\t")"), "\"\\/\b\f\n\r\t");
  EXPECT_EQ(text_of(R"("\u0041\u00e9\u20AC")"), "A\xC3\xA9\xE2\x82\xAC");
  EXPECT_EQ(text_of(R"("\ud83d\ude00")"), "\xF0\x9F\x98\x80");
  EXPECT_EQ(text_of(R"("\uD800\uDC00\uDBFF\uDFFF")"), "\xF0\x90\x80\x80\xF4\x8F\xBF\xBF");
  for (const char* text : {R"("\x")", R"("\u12g4")", R"("\u12)", R"("\)"})
    EXPECT_TRUE(contains(fault_of_text(text), "escape")) << text;
  for (const char* text : {R"("\ud83d")", R"("\ud83d\u0041")", R"("\ude00")", R"("\ud83d\n")"})
    EXPECT_TRUE(contains(fault_of_text(text), "half of a surrogate pair")) << text;
}

TEST(JsonScanner, strings_are_utf8_without_control_characters) {
  const std::string whole =
      "\x7F\xC2\x80\xDF\xBF\xE0\xA0\x80\xED\x9F\xBF\xF0\x90\x80\x80\xF4\x8F\xBF\xBF";
  EXPECT_EQ(text_of("\"" + whole + "\""), whole);
  for (const char* bad : {"\x80", "\xC0\x80", "\xC1\xBF", "\xC2x", "\xE0\x9F\xBF", "\xED\xA0\x80",
                          "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"})
    EXPECT_EQ(fault_of_text("\"a" + std::string(bad) + "\""),
              "f.json:1: not whole JSON: not UTF-8 at byte 2");
  EXPECT_TRUE(contains(fault_of_text("\"a\nb\""), "control character"));
  EXPECT_EQ(fault_of_text("\n\n\"abc"),
            "f.json:3: not whole JSON: a string that opens in line 3 does not close");
}

// The values that Fowler, Noll and Vo publish for FNV-1a of 64 bits.
TEST(JsonScanner, keeps_256_bytes_of_a_string_and_tells_longer_ones_apart) {
  const auto hash = [](const std::string& text) {
    return scanned("\"" + text + "\"", [](JsonScanner& scanner) {
      scanner.string();
      return scanner.hash();
    });
  };
  EXPECT_EQ(hash(""), 0xcbf29ce484222325U);
  EXPECT_EQ(hash("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(hash("foobar"), 0x85944171f73967e8U);
  const std::string large(1000, 'x');
  EXPECT_EQ(text_of("\"" + large + "\""), large.substr(0, 256));
  EXPECT_NE(hash(large), hash(large + "y"));
}

TEST(JsonScanner, says_what_is_expected_and_in_which_line) {
  const auto fault = [](const std::string& text, const std::function<void(JsonScanner&)>& call) {
    return complaint_of([&] { scanned(text, [&](JsonScanner& s) { return call(s), 0; }); });
  };
  EXPECT_EQ(fault("\n1", [](JsonScanner& s) { s.colon(); }),
            "f.json:2: not whole JSON: ':' is expected, not '1'");
  EXPECT_EQ(fault("  ", [](JsonScanner& s) { s.open('[', ']'); }),
            "f.json:1: not whole JSON: '[' is expected, not the end of the file");
  EXPECT_EQ(fault("\r\n}", [](JsonScanner& s) { s.more(']'); }),
            "f.json:2: not whole JSON: ']' is expected, not '}'");
  EXPECT_EQ(fault(" \n x", [](JsonScanner& s) { s.require_end(); }),
            "f.json:2: not whole JSON: text follows after the end: 'x'");
}

TEST(JsonScanner, passes_over_one_byte_order_mark_and_no_half_of_one) {
  EXPECT_EQ(text_of("\xEF\xBB\xBF\"a\""), "a");
  EXPECT_TRUE(contains(fault_of_text("\xEF\xBB\"a\""), "not UTF-8 at byte 0"));
}

TEST(JsonScanner, law_1_reads_the_same_wherever_its_bytes_are_parted) {
  const std::string json = "\xEF\xBB\xBF \"\\ud83d\\ude00 \xE9\x9B\xA8 \\n\"";
  for (std::size_t piece = 1; piece <= json.size(); ++piece)
    EXPECT_EQ(text_of(json, piece), "\xF0\x9F\x98\x80 \xE9\x9B\xA8 \n") << piece;
}

}  // namespace
}  // namespace thiessen
