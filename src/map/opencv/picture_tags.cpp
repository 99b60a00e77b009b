#include "map/opencv/picture_tags.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace thiessen {
namespace {

constexpr std::ptrdiff_t end_of_png_header = 8 + 25;  // the signature, and the chunk IHDR
constexpr std::size_t longest_comment = 65'000;

std::string big_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
    text += static_cast<char>(value >> static_cast<unsigned>(shift) & 0xFFU);
  return text;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto sum =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_endian(static_cast<std::uint32_t>(data.size()), 4) + body +
         big_endian(static_cast<std::uint32_t>(sum), 4);
}

std::string text_chunk(const std::string& name, const std::string& value) {
  const std::string keyword = name == "software" ? "Software" : name;
  const bool ascii =
      std::all_of(value.begin(), value.end(), [](char c) { return c >= ' ' && c <= '~'; });
  constexpr char nul = '\0';
  if (ascii) return chunk("tEXt", keyword + nul + value);
  // Not compressed, of no language, without a translated keyword.
  return chunk("iTXt", keyword + nul + nul + nul + nul + nul + value);
}

/// Where a comment may stand in a JPEG: behind its first mark and, where JFIF's header follows,
/// behind that, which JFIF wants first.
std::ptrdiff_t end_of_jpeg_header(const std::vector<unsigned char>& bytes) {
  constexpr std::ptrdiff_t mark = 2;
  constexpr std::size_t length_at = 4;
  const bool has_header = bytes.size() > length_at + 1 && bytes[2] == 0xFF && bytes[3] == 0xE0;
  return has_header ? mark + 2 + std::ptrdiff_t{256} * bytes[length_at] + bytes[length_at + 1]
                    : mark;
}

void insert(std::vector<unsigned char>& bytes, std::ptrdiff_t at, const std::string& text) {
  bytes.insert(bytes.begin() + at, text.begin(), text.end());
}

}  // namespace

void tag_png(std::vector<unsigned char>& bytes, const PictureTags& tags) {
  std::string chunks;
  for (const auto& [name, value] : tags) chunks += text_chunk(name, value);
  insert(bytes, end_of_png_header, chunks);
}

void tag_jpeg(std::vector<unsigned char>& bytes, const PictureTags& tags) {
  std::string comment;
  for (const auto& [name, value] : tags)
    comment += (comment.empty() ? "" : "; ") + (name == "software" ? value : name + ": " + value);
  if (comment.empty()) return;
  comment.resize(std::min(comment.size(), longest_comment));
  insert(bytes, end_of_jpeg_header(bytes),
         "\xFF\xFE" + big_endian(static_cast<std::uint32_t>(comment.size() + 2), 2) + comment);
}

void say_png_density(std::vector<unsigned char>& bytes, int dots_to_the_inch) {
  constexpr double inches_to_the_metre = 1 / 0.0254;
  constexpr char metre = 1;
  const std::string density = big_endian(
      static_cast<std::uint32_t>(std::lround(dots_to_the_inch * inches_to_the_metre)), 4);
  insert(bytes, end_of_png_header, chunk("pHYs", density + density + metre));
}

void say_jpeg_density(std::vector<unsigned char>& bytes, int dots_to_the_inch) {
  // The marker SOI, then APP0 with its length, the name, two bytes of version, the unit, and the
  // densities across and down.
  constexpr std::string_view name("JFIF\0", 5);
  constexpr std::size_t name_at = 6;
  constexpr std::size_t unit_at = name_at + name.size() + 2;
  constexpr unsigned char inch = 1;
  if (bytes.size() < unit_at + 5 ||
      !std::equal(name.begin(), name.end(), bytes.begin() + std::ptrdiff_t{name_at})) {
    return;
  }
  bytes[unit_at] = inch;
  const std::string density = big_endian(static_cast<std::uint32_t>(dots_to_the_inch), 2);
  const std::string both = density + density;
  std::copy(both.begin(), both.end(), bytes.begin() + std::ptrdiff_t{unit_at + 1});
}

}  // namespace thiessen
