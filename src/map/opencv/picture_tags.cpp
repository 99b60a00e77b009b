#include "map/opencv/picture_tags.h"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace thiessen {
namespace {

constexpr std::ptrdiff_t end_of_png_header = 8 + 25;  // the signature, and the chunk IHDR
constexpr std::ptrdiff_t end_of_jpeg_mark = 2;
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
  insert(bytes, end_of_jpeg_mark,
         "\xFF\xFE" + big_endian(static_cast<std::uint32_t>(comment.size() + 2), 2) + comment);
}

}  // namespace thiessen
