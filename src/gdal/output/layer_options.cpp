#include "gdal/output/layer_options.h"

#include <cpl_string.h>

#include <algorithm>

#include "base/error.h"
#include "base/utf8.h"
#include "text/json_text.h"

namespace thiessen {
namespace {

/// A name for a column of the format's own that no field has.
std::string free_name(const VectorLayer& layer, std::string name) {
  const auto is_taken = [&](const FieldName& field) { return lower_case(field.name) == name; };
  while (std::any_of(layer.fields.begin(), layer.fields.end(), is_taken)) name += '_';
  return name;
}

/// SQLite's reader takes a column of this name for the number of the feature.
void require_no_number_of_sqlite(const VectorLayer& layer, const std::string& path) {
  for (const FieldName& field : layer.fields) {
    if (lower_case(field.name) != "ogc_fid") continue;
    throw Error(Message{path, 0,
                        "the field " + quoted(field.name, 80) +
                            " cannot be written: the format keeps that name for itself",
                        "a .gpkg holds fields of any name"});
  }
}

bool is_ascii(const VectorLayer& layer) {
  const auto is_plain = [](char c) { return static_cast<unsigned char>(c) <= 127; };
  for (std::size_t row = 0; row < layer.values.rows; ++row) {
    for (std::size_t field = 0; field < layer.fields.size(); ++field) {
      const std::string bytes = layer.values.text(row, field);
      if (!std::all_of(bytes.begin(), bytes.end(), is_plain)) return false;
    }
  }
  return true;
}

/// The members of a GeoJSON that say how it was made.
std::string foreign_members(const Provenance& made_by) {
  std::string json = R"({"type":"FeatureCollection","made_by":{)";
  for (const auto& [name, value] : items_of(made_by)) {
    if (json.back() != '{') json += ',';
    append_json_string(json, name);
    json += ':';
    if (name == "tolerance") {
      json += value;  // is a number
    } else {
      append_json_string(json, value);
    }
  }
  return json + "}}";
}

void add_geojson(const VectorLayer& layer, bool has_crs, CPLStringList& options) {
  // Without a CRS the coordinates are a plane's, and no longitudes to be wrapped.
  if (has_crs) options.SetNameValue("RFC7946", "YES");
  if (!layer.made_by) return;
  options.SetNameValue("NATIVE_DATA", foreign_members(*layer.made_by).c_str());
  options.SetNameValue("NATIVE_MEDIA_TYPE", "application/vnd.geo+json");
}

void add_postgres(const VectorLayer& layer, CPLStringList& options) {
  options.SetNameValue("GEOMETRY_NAME", free_name(layer, "wkb_geometry").c_str());
  // Whoever runs the script decides about a table that is there: its CREATE fails.
  options.SetNameValue("DROP_TABLE", "NO");
  if (layer.made_by) options.SetNameValue("DESCRIPTION", sentence_of(*layer.made_by).c_str());
}

}  // namespace

CPLStringList file_options(const VectorLayer& layer, const std::string& driver) {
  CPLStringList options;
  if (driver == "GML" && layer.made_by)
    options.SetNameValue("DESCRIPTION", sentence_of(*layer.made_by).c_str());
  return options;
}

CPLStringList layer_options(const VectorLayer& layer, const std::string& driver, bool has_crs,
                            const std::string& path) {
  CPLStringList options;
  if (driver == "GeoJSON") add_geojson(layer, has_crs, options);
  if (driver == "CSV") options.SetNameValue("GEOMETRY", "AS_WKT");
  if (driver == "ESRI Shapefile") options.SetNameValue("DBF_DATE_LAST_UPDATE", "1970-01-01");
  // MapInfo's own name for UTF-8 is not known to GDAL, which warns of that.
  if (driver == "ESRI Shapefile" || (driver == "MapInfo File" && !is_ascii(layer)))
    options.SetNameValue("ENCODING", "UTF-8");
  if (driver == "GPKG") {
    options.SetNameValue("FID", free_name(layer, "fid").c_str());
    if (layer.shapes != VectorLayer::Shapes::none) {
      options.SetNameValue("GEOMETRY_NAME", free_name(layer, "geom").c_str());
      options.SetNameValue("SPATIAL_INDEX", "NO");  // it is SpatialIndex's
    }
  }
  if (driver == "SQLite" || driver == "PGDUMP") {
    options.SetNameValue("LAUNDER", "NO");
    options.SetNameValue("FID", free_name(layer, "ogc_fid").c_str());
  }
  if (driver == "SQLite") {
    require_no_number_of_sqlite(layer, path);
    options.SetNameValue("GEOMETRY_NAME", free_name(layer, "geometry").c_str());
  }
  if (driver == "PGDUMP") add_postgres(layer, options);
  return options;
}

}  // namespace thiessen
