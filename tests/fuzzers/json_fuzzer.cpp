#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/message_laws.h"
#include "fuzzers/plain_json.h"
#include "results/cell_features.h"
#include "results/cells_geojson.h"
#include "results/provenance.h"
#include "text/geojson_audit.h"
#include "text/json_scanner.h"
#include "text/json_text.h"
#include "text/text_bytes.h"

namespace thiessen::fuzzers {
namespace {

using Kind = Json::Kind;
using CrsMember = GeoJsonFindings::CrsMember;

constexpr const char* file = "fuzzed.geojson";

/// Requires that a list of coordinates nests so deep, and that its numbers are numbers of doubles.
/// All of a geometry's coordinates may be an empty list, and so may a ring.
void require_coordinates(const Json& list, int depth, bool is_whole = false) {
  require(list.kind == Kind::array, "accepted coordinates that are no list");
  const std::size_t length = list.values.size();
  require(depth > 1 || length > 1 || (is_whole && length == 0), "accepted half a position");
  for (const Json& value : list.values) {
    if (depth > 1) {
      require_coordinates(value, depth - 1);
    } else {
      const bool is_number = value.kind == Kind::number && parse_number(value.text);
      require(is_number, "accepted a coordinate that is no number: " + value.text);
    }
  }
}

void require_geometry(const Json& geometry) {
  struct Type {
    std::string_view name;
    int depth;
  };
  constexpr std::array<Type, 6> types = {{{"Point", 1},
                                          {"MultiPoint", 2},
                                          {"LineString", 2},
                                          {"MultiLineString", 3},
                                          {"Polygon", 3},
                                          {"MultiPolygon", 4}}};
  const Json* const type = geometry.member("type");
  require(type != nullptr && type->kind == Kind::string, "accepted a geometry without a type");
  if (type->is("GeometryCollection")) {
    const Json* const parts = geometry.member("geometries");
    if (parts == nullptr || parts->kind != Kind::array) return;
    for (const Json& part : parts->values)
      if (!part.is("null")) require_geometry(part);
    return;
  }
  const auto known = std::find_if(types.begin(), types.end(),
                                  [&](const Type& candidate) { return type->is(candidate.name); });
  require(known != types.end(), "accepted a geometry of no type");
  const Json* const coordinates = geometry.member("coordinates");
  require(coordinates != nullptr, "accepted a geometry without coordinates");
  require_coordinates(*coordinates, known->depth, true);
}

void require_feature(const Json& feature) {
  require(feature.kind == Kind::object, "accepted a feature that is no object");
  const Json* const geometry = feature.member("geometry");
  if (geometry != nullptr && geometry->kind == Kind::object) require_geometry(*geometry);
}

/// Requires that what was found in an accepted text is there, and that its numbers are sound.
void require_found(const Json& json, const GeoJsonFindings& found) {
  const Json* const features = json.member("features");
  const Json* const type = json.member("type");
  require(type != nullptr, "accepted a text without a type");
  if (features != nullptr) {
    require(type->is("FeatureCollection"), "accepted features of another type");
    require(found.features == features->values.size(), "another count of features");
    for (const Json& feature : features->values) require_feature(feature);
  } else {
    require(found.features == 1, "a count of features without a list");
    if (type->is("Feature")) {
      require_feature(json);
    } else {
      require_geometry(json);
    }
  }
  const Json* const crs = json.member("crs");
  require((crs == nullptr) == (found.crs == CrsMember::absent), "another crs member");
  require(found.crs != CrsMember::null || crs->is("null"), "a crs that is not null");
}

/// Whether a message begins with the path of a value that is there.
bool names_a_place(const Json& json, std::string_view message, bool at_root) {
  if (!at_root && message.starts_with(": ")) return true;
  if (json.kind == Kind::array) {
    for (std::size_t i = 0; i < json.values.size(); ++i) {
      const std::string step = "[" + std::to_string(i) + "]";
      if (message.starts_with(step) &&
          names_a_place(json.values[i], message.substr(step.size()), false))
        return true;
    }
  }
  for (std::size_t i = 0; i < json.keys.size(); ++i) {
    // The scanner keeps so many bytes of a key.
    const std::string step = (at_root ? "" : ".") + printable(json.keys[i].substr(0, 256));
    if (message.starts_with(step) &&
        names_a_place(json.values[i], message.substr(step.size()), false))
      return true;
  }
  return false;
}

/// Requires that a complaint about whole JSON names a value that is there, or is about the whole
/// text; and that one about text that is not whole JSON is right.
void require_reason(const Message& message, const std::optional<Json>& json, bool is_strict,
                    std::string_view text) {
  const std::string reason = message.text.plain();
  if (!reason.starts_with("not whole JSON: ")) {
    constexpr std::array<std::string_view, 5> of_all = {"has no type", "type is '", "a ", "'",
                                                        "coordinates are not nested as"};
    const bool is_of_all = std::any_of(of_all.begin(), of_all.end(), [&](std::string_view begin) {
      return reason.starts_with(begin);
    });
    require(json && (is_of_all || names_a_place(*json, reason, true)),
            "a path that leads nowhere: " + reason);
    return;
  }
  require(message.line > 0, "no line where JSON ends: " + reason);
  constexpr std::array<std::string_view, 4> of_json = {"deep", "is given twice", "longer than 4096",
                                                       "an object is expected"};
  require(!json || !is_strict ||
              std::any_of(
                  of_json.begin(), of_json.end(),
                  [&](std::string_view part) { return reason.find(part) != std::string::npos; }),
          "refused, and yet JSON: " + reason);
  constexpr std::string_view not_utf8 = "not whole JSON: not UTF-8 at byte ";
  if (!reason.starts_with(not_utf8)) return;
  const auto invalid = find_invalid_utf8(text);
  require(invalid && reason == std::string(not_utf8) + std::to_string(*invalid),
          "another byte that is not UTF-8: " + reason);
}

void audit(std::string_view text, std::size_t piece) {
  PlainJson reader(text);
  const std::optional<Json> json = reader.read();
  std::string last;
  for (const std::size_t size : {std::size_t{65536}, piece}) {
    TextBytes source{std::string(text), size};
    std::string complaint;
    try {
      const GeoJsonFindings found = audit_geojson(file, source);
      require(json && reader.is_strict(), "accepted, and yet no JSON");
      require_found(*json, found);
    } catch (const Error& error) {
      require_placed(error, file, lines_of(text));
      for (const Message& message : error.messages())
        require_reason(message, json, reader.is_strict(), text);
      complaint = error.what();
    }
    require(size != piece || complaint == last, "another answer in other pieces");
    last = complaint;
  }
}

/// Any text written as a string of JSON is read as that text, but for the bytes that are no UTF-8.
void write_string(std::string_view text, std::size_t piece) {
  std::string written;
  append_json_string(written, text);
  require(!find_invalid_utf8(written) && written.find('<') == std::string::npos &&
              written.find("\xE2\x80\xA8") == std::string::npos,
          "a string that is not safe to paste");
  std::string expected;
  while (!text.empty()) {
    const std::size_t valid = valid_utf8_prefix(text).valid;
    expected += text.substr(0, valid);
    if (valid == text.size()) break;
    expected += "\xEF\xBF\xBD";
    text.remove_prefix(valid + 1);
  }
  const auto json = PlainJson(written).read();
  require(json && json->is(expected), "another text once written and read again");
  TextBytes source(written, piece);
  JsonScanner scanner(file, source);
  require(scanner.string() == expected.substr(0, 256), "another text in the scanner");
  scanner.require_end();
}

/// What is written of cells is accepted, whatever stations, basins and attributes are called.
void write_cells(Bytes& bytes) {
  CellFeatures features;
  Attributes attributes;
  const auto any_text = [&] {
    const std::string_view text = bytes.until('\n');
    return std::string(text.substr(0, valid_utf8_prefix(text).valid));
  };
  const auto any_provenance = [&] {
    Provenance made_by;
    made_by.plane = any_text();
    made_by.method = any_text();
    made_by.unit = any_text();
    return made_by;
  };
  const std::size_t flags = bytes.next();
  features.has_rainfall = flags % 2 == 0;
  features.rainfall_is = any_text();
  features.attributes = &attributes;
  if (flags / 8 % 2 == 0) features.made_by = any_provenance();
  attributes.fields = {{any_text(), FieldType::text}, {any_text(), FieldType::real}};
  std::vector<MultiPolygon> shapes;
  for (std::size_t i = 0; i < flags / 2 % 4; ++i) {
    const double x = static_cast<double>(bytes.next()) / 10;
    const double size = std::ldexp(1, static_cast<int>(bytes.below(60)) - 30);
    shapes.push_back({{{{x, 1}, {x + size, 1}, {x, 1 + size}}, {}}});
    features.cells.push_back(
        {any_text(), any_text(), size, std::log(x), 1 + x, -size, i, shapes.back()});
    attributes.rows.push_back({any_text(), any_text()});
  }
  const std::string written = cells_geojson(features, shapes, VertexRounding());
  TextBytes source(written);
  require(audit_geojson(file, source).features == shapes.size(), "another count of cells");
  require(PlainJson(written).read().has_value(), "cells that are no JSON");
}

}  // namespace

void fuzz_json(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  const std::size_t kind = bytes.below(8);
  const std::size_t piece = 1 + bytes.below(20);
  if (kind == 0) return write_string(bytes.rest(), piece);
  if (kind == 1) return write_cells(bytes);
  audit(bytes.rest(), piece);
}

}  // namespace thiessen::fuzzers
