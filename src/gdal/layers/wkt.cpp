#include "gdal/layers/wkt.h"

#include <ogr_geometry.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>

#include "base/number.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_conversion.h"

namespace thiessen {
namespace {

/// Reads polygons in the form in which nearly all are written, in a part of the time that GDAL
/// takes. Whatever else is there, and be it a blank or a third coordinate, is left to GDAL.
class PlainPolygons {
 public:
  explicit PlainPolygons(std::string_view wkt) : rest_(wkt) {}

  std::optional<GeometryRecord> record() {
    GeometryRecord record;
    const bool is_read =
        take("POLYGON") ? read(record, "Polygon", [&] { return read_polygon(record.polygons); })
                        : take("MULTIPOLYGON") && read(record, "MultiPolygon", [&] {
                            return list([&] { return read_polygon(record.polygons); });
                          });
    return is_read && rest_.empty() ? std::optional(std::move(record)) : std::nullopt;
  }

 private:
  template <typename Shape>
  bool read(GeometryRecord& record, const char* type, const Shape& shape) {
    record.type = type;
    take(" ");
    return shape();
  }

  /// A list in brackets, of which `item` reads one after the other.
  template <typename Item>
  bool list(const Item& item) {
    if (!take("(")) return false;
    do {
      take(" ");
      if (!item()) return false;
    } while (take(","));
    return take(")");
  }

  bool read_polygon(MultiPolygon& polygons) {
    Polygon polygon;
    bool is_first = true;
    const bool is_read = list([&] {
      Ring& into = is_first ? polygon.outer : polygon.holes.emplace_back();
      is_first = false;
      return read_ring(into);
    });
    polygons.push_back(std::move(polygon));
    return is_read;
  }

  bool read_ring(Ring& ring) {
    constexpr std::size_t fewest = 4;
    const bool is_read = list([&] {
      Point& point = ring.emplace_back();
      return read_number(point.x) && take(" ") && read_number(point.y);
    });
    return is_read && ring.size() >= fewest && ring.front() == ring.back();
  }

  bool read_number(double& value) {
    constexpr std::size_t longest = 60;  // longer ones GDAL takes apart
    const auto ends = [](char c) { return c == ' ' || c == ',' || c == '(' || c == ')'; };
    const auto end = static_cast<std::size_t>(std::ranges::find_if(rest_, ends) - rest_.begin());
    if (end > longest || rest_.starts_with('+')) return false;
    const auto number = parse_number(rest_.substr(0, end));
    rest_.remove_prefix(end);
    value = number.value;
    return static_cast<bool>(number);
  }

  bool take(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }

  std::string_view rest_;
};

}  // namespace

std::optional<GeometryRecord> record_of_wkt(const std::string& wkt) {
  if (auto plain = PlainPolygons(wkt).record()) return plain;
  if (wkt.find_first_not_of(" \t\r\n") == std::string::npos) return GeometryRecord{};
  const GdalErrors errors;
  const char* rest = wkt.c_str();
  OGRGeometry* parsed = nullptr;
  const OGRErr failed = OGRGeometryFactory::createFromWkt(&rest, nullptr, &parsed);
  const std::unique_ptr<OGRGeometry> geometry(parsed);
  if (failed != OGRERR_NONE || !geometry) return std::nullopt;
  if (rest != nullptr && std::strspn(rest, " \t\r\n") != std::strlen(rest)) return std::nullopt;
  return record_of(geometry.get());
}

}  // namespace thiessen
