#include "results/cells_geojson.h"

#include <cmath>
#include <vector>

#include "base/interrupt.h"
#include "base/number.h"
#include "results/feature_text.h"
#include "text/json_text.h"

namespace thiessen {
namespace {

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

void append_properties(std::string& out, const CellFeatures& features, const CellFeature& cell,
                       const std::vector<FieldName>& attributes) {
  append_name(out, "station");
  append_json_string(out, cell.station);
  if (cell.basin) {
    append_name(out, "basin");
    append_json_string(out, *cell.basin);
  }
  append_name(out, features.area_column);
  append_number(out, cell.area);
  append_name(out, "weight");
  append_number(out, cell.weight);
  if (features.has_factor) {
    append_name(out, "factor");
    append_number(out, cell.factor);
  }
  if (features.has_rainfall) {
    append_name(out, "rainfall");
    append_number(out, cell.rainfall);
  }
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    append_name(out, attributes[i].name);
    append_value(out, features.attributes->rows[cell.attribute_row][i], attributes[i].type);
  }
}

}  // namespace

CellsGeojson::CellsGeojson(const CellFeatures& features, const VertexRounding& rounding)
    : features_(features), rounding_(rounding), attributes_(attribute_fields(features)) {}

void CellsGeojson::begin(std::string& out) const {
  out += R"({"type":"FeatureCollection",)";
  if (features_.made_by) append_provenance(out, *features_.made_by);
  if (features_.has_rainfall && !features_.rainfall_is.empty()) {
    out += R"("rainfall":)";
    append_json_string(out, features_.rainfall_is);
    out += ',';
  }
  out += R"("features":[)";
}

void CellsGeojson::append(std::string& out, const CellFeature& cell, const MultiPolygon& shape) {
  out += any_ ? ",\n" : "\n";
  any_ = true;
  out += R"({"type":"Feature","properties":{)";
  append_properties(out, features_, cell, attributes_);
  out += R"(},"geometry":)";
  append_geometry(out, shape, rounding_);
  out += '}';
}

void CellsGeojson::end(std::string& out) const {
  out += "\n]}\n";
}

std::string cells_geojson(const CellFeatures& features, std::span<const MultiPolygon> shapes,
                          const VertexRounding& rounding) {
  CellsGeojson geojson(features, rounding);
  std::string out;
  geojson.begin(out);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    throw_if_interrupted();
    geojson.append(out, features.cells[i], shapes[i]);
  }
  geojson.end(out);
  return out;
}

}  // namespace thiessen
