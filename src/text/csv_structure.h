#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace thiessen {

/// How many bytes of a CSV text are looked at together.
constexpr std::size_t csv_block = 64;

/// Finds the bytes that can end a field among the 64 bytes at `text`: one bit for each, set where
/// the byte is the separator, a quote, a line feed or a carriage return. Requires that all 64 bytes
/// are readable.
inline std::uint64_t csv_structure(const char* text, char separator) {
  std::uint64_t bits = 0;
#if defined(__SSE2__)
  const __m128i separators = _mm_set1_epi8(separator);
  const __m128i quotes = _mm_set1_epi8('"');
  const __m128i line_feeds = _mm_set1_epi8('\n');
  const __m128i returns = _mm_set1_epi8('\r');
  for (unsigned i = 0; i < csv_block; i += 16) {
    const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(text + i));
    const __m128i fields =
        _mm_or_si128(_mm_cmpeq_epi8(bytes, separators), _mm_cmpeq_epi8(bytes, quotes));
    const __m128i lines =
        _mm_or_si128(_mm_cmpeq_epi8(bytes, line_feeds), _mm_cmpeq_epi8(bytes, returns));
    const int found = _mm_movemask_epi8(_mm_or_si128(fields, lines));
    bits |= static_cast<std::uint64_t>(static_cast<unsigned>(found)) << i;
  }
#else
  for (unsigned i = 0; i < csv_block; ++i) {
    const char c = text[i];
    const bool found = c == separator || c == '"' || c == '\n' || c == '\r';
    bits |= static_cast<std::uint64_t>(found) << i;
  }
#endif
  return bits;
}

}  // namespace thiessen
