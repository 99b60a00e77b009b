#include "text/decoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/error.h"

namespace thiessen {
namespace {

using namespace std::literals;

/// Decodes a text that comes in pieces of so many bytes, into room for so many.
std::string decoded(const std::string& encoding, std::string text, std::size_t piece = 1,
                    std::size_t room = 4) {
  InputFile file("t", [&](std::span<char> into) {
    const std::size_t count = std::min({piece, into.size(), text.size()});
    std::copy_n(text.begin(), count, into.begin());
    text.erase(0, count);
    return count;
  });
  Decoder decoder(encoding);
  std::string result;
  std::string buffer(room, '\0');
  while (const std::size_t count = decoder.read(file, buffer)) result.append(buffer, 0, count);
  if (decoder.fault()) result += "<" + std::to_string(*decoder.fault()) + ">";
  return result;
}

TEST(Decoder, reads_bytes_of_one_and_of_several_in_any_pieces) {
  for (const std::size_t piece : {1U, 2U, 3U, 100U}) {
    for (const std::size_t room : {4U, 5U, 100U}) {
      EXPECT_EQ(decoded("Latin-1", "Z\xFCrich", piece, room), "Z\xC3\xBCrich");
      EXPECT_EQ(decoded("cp932", "\x89\x4A,\x83\x5C", piece, room), "\xE9\x9B\xA8,\xE3\x82\xBD");
      EXPECT_EQ(decoded("UTF-16", "\xFF\xFE\x3D\xD8\x27\xDC"s, piece, room), "\xF0\x9F\x90\xA7");
    }
  }
}

TEST(Decoder, knows_encodings_by_their_usual_names) {
  for (const char* name : {"Latin-1", "latin1", "ISO-8859-15", "cp932", "Windows-1252",
                           "windows_1252", "Shift_JIS", "UTF-8", "UTF-16LE"})
    EXPECT_TRUE(is_encoding(name)) << name;
  for (const char* name : {"", "-", "Latin", "UTF-8//IGNORE", "no such"})
    EXPECT_FALSE(is_encoding(name)) << name;
  EXPECT_THROW(Decoder("no such"), Error);
}

TEST(Decoder, stops_at_what_is_not_of_the_encoding) {
  EXPECT_EQ(decoded("cp932", "ab\x81\xFF"), "ab<2>");
  EXPECT_EQ(decoded("UTF-16", "\xFF\xFE\x61\0b"s), "a<4>") << "half a character at the end";
}

}  // namespace
}  // namespace thiessen
