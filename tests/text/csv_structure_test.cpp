#include "text/csv_structure.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>

namespace thiessen {
namespace {

/// The definition, a byte at a time.
std::uint64_t ends_of_fields(const char* text, char separator) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < csv_block; ++i) {
    const char c = text[i];
    if (c == separator || c == '"' || c == '\n' || c == '\r') bits |= std::uint64_t{1} << i;
  }
  return bits;
}

TEST(CsvStructure, law_1_every_byte_is_an_end_of_a_field_in_every_place_or_in_none) {
  for (const char separator : {',', ';', '\t', '|', ' '}) {
    for (int byte = 0; byte < 256; ++byte) {
      const char c = static_cast<char>(byte);
      const bool ends = c == separator || c == '"' || c == '\n' || c == '\r';
      for (std::size_t place = 0; place < csv_block; ++place) {
        std::string text(csv_block, 'x');
        text[place] = c;
        ASSERT_EQ(csv_structure(text.data(), separator),
                  ends ? std::uint64_t{1} << place : std::uint64_t{0})
            << "byte " << byte << " in place " << place;
      }
    }
  }
}

TEST(CsvStructure, law_2_is_the_definition_wherever_in_memory_the_text_begins) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  constexpr std::array<char, 8> likely = {',', '"', '\n', '\r', ';', '1', '\0', '\xC3'};
  std::string text(10'000, '\0');
  for (char& c : text) {
    const auto byte = static_cast<char>(random() % 256);
    c = random() % 2 == 0 ? likely[random() % likely.size()] : byte;
  }
  for (std::size_t begin = 0; begin + csv_block <= text.size(); ++begin) {
    ASSERT_EQ(csv_structure(text.data() + begin, ','), ends_of_fields(text.data() + begin, ','))
        << begin;
  }
}

TEST(CsvStructure, a_comma_is_no_end_where_another_sign_separates) {
  std::string text(csv_block, ',');
  text[63] = ';';
  EXPECT_EQ(csv_structure(text.data(), ';'), std::uint64_t{1} << 63U);
  EXPECT_EQ(csv_structure(text.data(), ','), ~(std::uint64_t{1} << 63U));
}

}  // namespace
}  // namespace thiessen
