#include <cmath>
#include <unordered_set>

#include "base/number.h"
#include "base/utf8.h"
#include "io/cells_fields.h"
#include "io/cells_file.h"
#include "io/cells_shapes.h"
#include "outlines/vertex_rounding.h"
#include "text/json_text.h"

namespace thiessen {
namespace {

void append_name(std::string& out, std::string_view name) {
  if (out.back() != '{') out += ',';
  append_json_string(out, name);
  out += ':';
}

void append_value(std::string& out, const std::string& text, FieldType type) {
  const auto number = parse_number(text);
  if (text.empty()) {
    out += "null";
  } else if (type == FieldType::integer) {
    out += text;
  } else if (type == FieldType::real && number) {
    append_shortest(out, number.value);
  } else {
    append_json_string(out, text);
  }
}

void append_number(std::string& out, double value) {
  if (std::isfinite(value)) {
    append_shortest(out, value);
  } else {
    out += "null";
  }
}

void append_properties(std::string& out, const CellsOutput& output, const CellFeature& cell,
                       const std::vector<FieldName>& attributes) {
  append_name(out, "station");
  append_json_string(out, cell.station);
  if (cell.basin) {
    append_name(out, "basin");
    append_json_string(out, *cell.basin);
  }
  append_name(out, "area_km2");
  append_number(out, cell.area_km2);
  append_name(out, "weight");
  append_number(out, cell.weight);
  if (output.has_rainfall) {
    append_name(out, "rainfall");
    append_number(out, cell.rainfall);
  }
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    append_name(out, attributes[i].name);
    append_value(out, output.attributes->rows[cell.attribute_row][i], attributes[i].type);
  }
}

void append_polygon(std::string& out, const Polygon& polygon, const VertexRounding& rounding) {
  out += '[';
  rounding.append(out, polygon.outer);
  for (const Ring& hole : polygon.holes) {
    out += ',';
    rounding.append(out, hole);
  }
  out += ']';
}

void append_geometry(std::string& out, const MultiPolygon& shape, const VertexRounding& rounding) {
  if (shape.empty()) {
    out += "null";
  } else if (shape.size() == 1) {
    out += R"({"type":"Polygon","coordinates":)";
    append_polygon(out, shape[0], rounding);
    out += '}';
  } else {
    out += R"({"type":"MultiPolygon","coordinates":[)";
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (i > 0) out += ',';
      append_polygon(out, shape[i], rounding);
    }
    out += "]}";
  }
}

}  // namespace

std::vector<FieldName> attribute_fields(const CellsOutput& output) {
  if (output.attributes == nullptr) return {};
  std::unordered_set<std::string> taken = {"station", "basin", "area_km2", "weight", "rainfall"};
  std::vector<FieldName> fields = output.attributes->fields;
  for (FieldName& field : fields) {
    while (!taken.insert(lower_case(field.name)).second) field.name += '_';
  }
  return fields;
}

std::string cells_geojson(const CellsOutput& output) {
  const std::optional<Crs> target = output.study_crs ? std::optional(Crs::wgs84()) : std::nullopt;
  const std::vector<MultiPolygon> shapes = cells_shapes(output, target);
  const VertexRounding rounding =
      target ? VertexRounding(shapes, decimals_for(output.tolerance)) : VertexRounding();
  const std::vector<FieldName> attributes = attribute_fields(output);
  std::string out = R"({"type":"FeatureCollection","features":[)";
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    out += i == 0 ? "\n" : ",\n";
    out += R"({"type":"Feature","properties":{)";
    append_properties(out, output, output.cells[i], attributes);
    out += R"(},"geometry":)";
    append_geometry(out, shapes[i], rounding);
    out += '}';
  }
  out += "\n]}\n";
  return out;
}

}  // namespace thiessen
