#include "gdal/layers/geometry_text.h"

#include <ogr_geometry.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "base/number.h"
#include "base/utf8.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_conversion.h"
#include "gdal/layers/wkt.h"

namespace thiessen {
namespace {

/// Of WKB: a byte for the order of bytes, and four for the type of the geometry.
constexpr std::size_t wkb_header = 5;
constexpr std::uint32_t has_srid = 0x20000000;

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::vector<unsigned char> bytes_in(std::string_view digits) {
  std::vector<unsigned char> bytes;
  if (digits.size() % 2 != 0 || digits.size() / 2 < wkb_header) return bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const int high = digit_of(digits[i]);
    const int low = digit_of(digits[i + 1]);
    if (high < 0 || low < 0) return {};
    bytes.push_back(static_cast<unsigned char>(high * 16 + low));
  }
  return bytes;
}

std::uint32_t number_at(const std::vector<unsigned char>& bytes, std::size_t at) {
  const bool little = bytes[0] == 1;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number |= std::uint32_t{bytes[at + (little ? i : 3 - i)]} << (8 * i);
  return number;
}

/// Takes the SRID out of PostGIS's form of WKB, so that what is left is plain.
int take_srid(std::vector<unsigned char>& bytes) {
  const std::uint32_t type = number_at(bytes, 1);
  constexpr std::size_t srid_bytes = 4;
  if ((type & has_srid) == 0 || bytes.size() < wkb_header + srid_bytes) return 0;
  const auto srid = static_cast<int>(number_at(bytes, wkb_header));
  bytes.erase(bytes.begin() + wkb_header, bytes.begin() + wkb_header + srid_bytes);
  bytes[bytes[0] == 1 ? 4 : 1] &= static_cast<unsigned char>(~(has_srid >> 24));
  return srid;
}

std::optional<GeometryText> of_wkb(std::string_view digits) {
  std::vector<unsigned char> bytes = bytes_in(digits);
  if (bytes.empty() || bytes[0] > 1) return std::nullopt;
  const int srid = take_srid(bytes);
  const GdalErrors errors;
  OGRGeometry* parsed = nullptr;
  const OGRErr failed =
      OGRGeometryFactory::createFromWkb(bytes.data(), nullptr, &parsed, bytes.size());
  const std::unique_ptr<OGRGeometry> geometry(parsed);
  if (failed != OGRERR_NONE || !geometry) return std::nullopt;
  return GeometryText{record_of(geometry.get()), srid};
}

std::optional<GeometryText> of_ewkt(std::string_view text) {
  constexpr std::string_view mark = "SRID=";
  const std::size_t end = text.find(';');
  if (end == std::string_view::npos) return std::nullopt;
  constexpr std::size_t largest_code = 999'999;
  const auto srid = parse_size(trimmed(text.substr(mark.size(), end - mark.size())));
  if (!srid || srid.value > largest_code) return std::nullopt;
  auto geometry = record_of_wkt(std::string(text.substr(end + 1)));
  if (!geometry) return std::nullopt;
  return GeometryText{*std::move(geometry), static_cast<int>(srid.value)};
}

}  // namespace

std::optional<GeometryText> geometry_of_text(const std::string& text) {
  const std::string_view bare = trimmed(text);
  if (bare.size() > 5 && equal_ignoring_case(bare.substr(0, 5), "SRID=")) return of_ewkt(bare);
  if (!bare.empty() && bare.front() == '0') return of_wkb(bare);
  auto geometry = record_of_wkt(text);
  if (!geometry) return std::nullopt;
  return GeometryText{*std::move(geometry), 0};
}

}  // namespace thiessen
