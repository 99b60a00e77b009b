#include "results/feature_text.h"

#include <cstddef>

#include "text/json_text.h"

namespace thiessen {
namespace {

void append_polygon(std::string& out, const Polygon& polygon, const VertexRounding& rounding) {
  out += '[';
  rounding.append(out, polygon.outer);
  for (const Ring& hole : polygon.holes) {
    out += ',';
    rounding.append(out, hole);
  }
  out += ']';
}

}  // namespace

void append_name(std::string& out, std::string_view name) {
  if (out.back() != '{') out += ',';
  append_json_string(out, name);
  out += ':';
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

void append_provenance(std::string& out, const Provenance& made_by) {
  out += R"("made_by":{)";
  for (const auto& [name, value] : items_of(made_by)) {
    if (name == "rainfall") continue;  // is said by a member of its own
    append_name(out, name);
    if (name == "tolerance") {
      out += value;
    } else {
      append_json_string(out, value);
    }
  }
  out += "},\n";
}

}  // namespace thiessen
