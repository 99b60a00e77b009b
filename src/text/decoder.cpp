#include "text/decoder.h"

#include <iconv.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t raw_bytes = std::size_t{64} << 10;

bool is_refused(iconv_t conversion) {
  return conversion == reinterpret_cast<iconv_t>(-1);  // NOLINT(performance-no-int-to-ptr)
}

/// Names are tried as they are, with hyphens for what parts their words, and without: Windows 1252
/// is iconv's WINDOWS-1252, and Latin-1 its LATIN1.
iconv_t open_conversion(const std::string& name) {
  // What follows a slash would change what iconv does with bytes that it cannot read.
  iconv_t conversion = reinterpret_cast<iconv_t>(-1);  // NOLINT(performance-no-int-to-ptr)
  if (name.empty() || name.find('/') != std::string::npos) return conversion;
  std::string hyphened = name;
  std::ranges::replace_if(
      hyphened, [](char c) { return c == '_' || c == ' '; }, '-');
  std::string joined = hyphened;
  std::erase(joined, '-');
  for (const std::string& spelling : {name, hyphened, joined}) {
    if (spelling.empty()) continue;
    conversion = ::iconv_open("UTF-8", spelling.c_str());
    if (!is_refused(conversion)) break;
  }
  return conversion;
}

}  // namespace

void Decoder::Close::operator()(void* conversion) const {
  ::iconv_close(conversion);
}

bool is_encoding(const std::string& name) {
  iconv_t conversion = open_conversion(name);
  if (is_refused(conversion)) return false;
  ::iconv_close(conversion);
  return true;
}

std::string decoded(std::string_view text, const std::string& encoding) {
  Decoder decoder(encoding, text);
  InputFile none("", [](std::span<char>) { return std::size_t{0}; });
  std::string all;
  constexpr std::size_t part = 4096;
  for (std::size_t count = part; count > 0;) {
    const std::size_t size = all.size();
    all.resize(size + part);
    count = decoder.read(none, std::span<char>(all).subspan(size));
    all.resize(size + count);
  }
  return all;
}

Decoder::Decoder(std::string encoding, std::string_view begun)
    : encoding_(std::move(encoding)),
      raw_(std::max(raw_bytes, begun.size())),
      end_(begun.copy(raw_.data(), begun.size())) {
  iconv_t conversion = open_conversion(encoding_);
  if (is_refused(conversion)) {
    throw Error({"", 0, quoted(encoding_, 80) + " is no encoding that is known here",
                 "such as Latin-1, Windows-1252 or cp932"});
  }
  conversion_.reset(conversion);
}

std::size_t Decoder::read(InputFile& from, std::span<char> into) {
  while (!fault_) {
    const std::size_t written = convert(into);
    if (written > 0) return written;
    if (fault_ || !read_more(from)) break;
  }
  if (fault_ || std::exchange(flushed_, true)) return 0;
  char* out = into.data();  // a letter that waited for a mark behind it
  std::size_t out_left = into.size();
  ::iconv(conversion_.get(), nullptr, nullptr, &out, &out_left);
  return into.size() - out_left;
}

/// Reads behind what is left of a character that the last bytes begin. Returns false at the end.
bool Decoder::read_more(InputFile& from) {
  if (at_end_) return false;
  std::memmove(raw_.data(), raw_.data() + begin_, end_ - begin_);
  origin_ += begin_;
  end_ -= begin_;
  begin_ = 0;
  const std::size_t count = from.read(std::span(raw_).subspan(end_));
  end_ += count;
  at_end_ = count == 0;
  if (at_end_ && end_ > 0) fault_ = origin_;  // the last character is cut off
  return !at_end_;
}

std::size_t Decoder::convert(std::span<char> into) {
  if (begin_ == end_) return 0;
  char* in = raw_.data() + begin_;
  std::size_t in_left = end_ - begin_;
  char* out = into.data();
  std::size_t out_left = into.size();
  const std::size_t result = ::iconv(conversion_.get(), &in, &in_left, &out, &out_left);
  const int why = errno;
  begin_ = end_ - in_left;
  holds_more_ = result == static_cast<std::size_t>(-1) && why == E2BIG;
  if (result == static_cast<std::size_t>(-1) && why == EILSEQ) fault_ = origin_ + begin_;
  return into.size() - out_left;
}

}  // namespace thiessen
