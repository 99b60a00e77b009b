#include "gdal/output/isohyets_file.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <memory>

#include "gdal/crs/crs_definition.h"
#include "gdal/gdal_errors.h"
#include "gdal/output/fixed_date.h"
#include "gdal/output/layer_formats.h"
#include "gdal/output/layer_readback.h"
#include "gdal/output/memory_files.h"
#include "text/json_text.h"

namespace thiessen {
namespace {

/// The members of a GeoJSON that say how it was made.
std::string foreign_members(const Provenance& made_by) {
  std::string json = R"({"type":"FeatureCollection","made_by":{)";
  for (const auto& [name, value] : items_of(made_by)) {
    if (json.back() != '{') json += ',';
    append_json_string(json, name);
    json += ':';
    append_json_string(json, value);
  }
  return json + "}}";
}

CPLStringList options_of(const std::string& driver, bool has_crs, const Provenance& made_by) {
  CPLStringList options;
  if (driver == "GeoJSON") {
    // Without a CRS the coordinates are a plane's, and no longitudes to be wrapped.
    if (has_crs) options.SetNameValue("RFC7946", "YES");
    options.SetNameValue("NATIVE_DATA", foreign_members(made_by).c_str());
    options.SetNameValue("NATIVE_MEDIA_TYPE", "application/vnd.geo+json");
  } else if (driver == "CSV") {
    options.SetNameValue("GEOMETRY", "AS_WKT");
  } else if (driver == "ESRI Shapefile") {
    options.SetNameValue("DBF_DATE_LAST_UPDATE", "1970-01-01");
    options.SetNameValue("ENCODING", "UTF-8");
  } else if (driver == "PGDUMP") {
    options.SetNameValue("LAUNDER", "NO");
    options.SetNameValue("DROP_TABLE", "NO");
    options.SetNameValue("DESCRIPTION", sentence_of(made_by).c_str());
  }
  return options;
}

class IsohyetsWriter {
 public:
  IsohyetsWriter(const std::string& path, GDALDriver& driver)
      : path_(path), driver_(driver), folder_(path) {}

  std::vector<EncodedFile> write(std::span<const Isohyet> isohyets,
                                 std::span<const std::string> basin_ids,
                                 const std::optional<Crs>& crs, const Provenance& made_by,
                                 Warnings& warnings) {
    const FixedDate date;
    dataset_.reset(driver_.Create(folder_.file().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    check(dataset_ != nullptr);
    OGRLayer& layer = create_layer(crs, made_by);
    for (const Isohyet& isohyet : isohyets) add(layer, isohyet, basin_ids[isohyet.basin]);
    dataset_.reset();
    check(true);
    require_whole(isohyets, basin_ids, warnings);
    for (const std::string& warning : errors_.warnings())
      warnings.add({path_, 0, "GDAL warns: " + warning, {}});
    return folder_.take();
  }

 private:
  void check(bool done) const {
    if (!done || errors_.failed())
      throw Error(Message{path_, 0, "GDAL cannot write it: " + errors_.text(), {}});
  }

  OGRLayer& create_layer(const std::optional<Crs>& crs, const Provenance& made_by) {
    const std::string driver = driver_.GetDescription();
    std::unique_ptr<OGRSpatialReference> system;
    if (crs) system.reset(crs->definition().system.Clone());
    OGRLayer* const layer =
        dataset_->CreateLayer("isohyets", system.get(), wkbMultiLineString,
                              options_of(driver, crs.has_value(), made_by).List());
    check(layer != nullptr);
    OGRFieldDefn basin("basin", OFTString);
    check(layer->CreateField(&basin) == OGRERR_NONE);
    OGRFieldDefn rainfall("rainfall", OFTReal);
    check(layer->CreateField(&rainfall) == OGRERR_NONE);
    if (driver == "GPKG") {
      for (const auto& [name, value] : items_of(made_by))
        layer->SetMetadataItem(name.c_str(), value.c_str());
    }
    return *layer;
  }

  void add(OGRLayer& layer, const Isohyet& isohyet, const std::string& basin) {
    const std::unique_ptr<OGRFeature, void (*)(OGRFeature*)> feature(
        OGRFeature::CreateFeature(layer.GetLayerDefn()), OGRFeature::DestroyFeature);
    auto lines = std::make_unique<OGRMultiLineString>();
    for (const auto& points : isohyet.lines) {
      auto line = std::make_unique<OGRLineString>();
      for (const Point p : points) line->addPoint(p.x, p.y);
      lines->addGeometryDirectly(line.release());
    }
    feature->SetGeometryDirectly(lines.release());
    feature->SetField("basin", basin.c_str());
    feature->SetField("rainfall", isohyet.level);
    check(layer.CreateFeature(feature.get()) == OGRERR_NONE);
  }

  /// Reads back what a format may have cut short.
  void require_whole(std::span<const Isohyet> isohyets, std::span<const std::string> basin_ids,
                     Warnings& warnings) const {
    const std::string driver = driver_.GetDescription();
    if (isohyets.empty() || driver == "GPKG" || driver == "GeoJSON" || driver == "PGDUMP") return;
    LayerTexts wanted;
    wanted.rows = isohyets.size();
    wanted.names = {"basin", "rainfall"};
    wanted.text = [&](std::size_t row, std::size_t field) {
      return field == 0 ? basin_ids[isohyets[row].basin] : std::string();
    };
    wanted.number = [&](std::size_t row, std::size_t field) {
      return field == 1 ? std::optional(isohyets[row].level) : std::nullopt;
    };
    require_read_back(driver_, folder_.file(), wanted, path_, warnings);
  }

  const std::string& path_;
  GDALDriver& driver_;
  MemoryFolder folder_;
  GdalErrors errors_;
  std::unique_ptr<GDALDataset> dataset_;
};

}  // namespace

std::vector<EncodedFile> isohyets_file(std::span<const Isohyet> isohyets,
                                       std::span<const std::string> basin_ids,
                                       const std::optional<Crs>& crs, const Provenance& made_by,
                                       const std::string& path, Warnings& warnings) {
  return IsohyetsWriter(path, require_vector_driver(path))
      .write(isohyets, basin_ids, crs, made_by, warnings);
}

}  // namespace thiessen
