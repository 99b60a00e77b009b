#include "results/triangles_geojson.h"

#include <cstddef>

#include "base/interrupt.h"
#include "results/feature_text.h"
#include "text/json_text.h"

namespace thiessen {

std::string triangles_geojson(const TriangleFeatures& features,
                              std::span<const MultiPolygon> shapes,
                              const VertexRounding& rounding) {
  std::string out = R"({"type":"FeatureCollection",)";
  if (features.made_by) append_provenance(out, *features.made_by);
  out += R"("features":[)";
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    throw_if_interrupted();
    out += i == 0 ? "\n" : ",\n";
    out += R"({"type":"Feature","properties":{)";
    for (std::size_t corner = 0; corner < corner_names.size(); ++corner) {
      append_name(out, corner_names.at(corner));
      append_json_string(out, features.triangles[i].stations.at(corner));
    }
    out += R"(},"geometry":)";
    append_geometry(out, shapes[i], rounding);
    out += '}';
  }
  out += "\n]}\n";
  return out;
}

}  // namespace thiessen
