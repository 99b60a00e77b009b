#include "gdal/output/cells_layer.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "base/utf8.h"
#include "gdal/crs/crs_definition.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_conversion.h"
#include "gdal/output/memory_files.h"
#include "gdal/output/written_validity.h"

namespace thiessen {
namespace {

struct Format {
  std::string_view extension;
  const char* driver;
};

constexpr std::array formats = {Format{"gpkg", "GPKG"},
                                Format{"shp", "ESRI Shapefile"},
                                Format{"shz", "ESRI Shapefile"},
                                Format{"fgb", "FlatGeobuf"},
                                Format{"kml", "LIBKML"},
                                Format{"kmz", "LIBKML"},
                                Format{"gml", "GML"},
                                Format{"tab", "MapInfo File"},
                                Format{"mif", "MapInfo File"},
                                Format{"sqlite", "SQLite"},
                                Format{"csv", "CSV"},
                                Format{"geojsonl", "GeoJSONSeq"},
                                Format{"gmt", "OGR_GMT"},
                                Format{"jml", "JML"},
                                Format{"sql", "PGDUMP"}};

bool writes(GDALDriver& driver, const std::string& extension) {
  const auto is_set = [&](const char* key) { return driver.GetMetadataItem(key) != nullptr; };
  if (!is_set(GDAL_DCAP_VECTOR) || !is_set(GDAL_DCAP_CREATE) || !is_set(GDAL_DCAP_VIRTUALIO))
    return false;
  // Spreadsheets hold no geometry.
  const std::string_view name = driver.GetDescription();
  if (name == "XLSX" || name == "ODS") return false;
  const char* known = driver.GetMetadataItem(GDAL_DMD_EXTENSIONS);
  const CPLStringList extensions(CSLTokenizeString2(known == nullptr ? "" : known, " ", 0));
  return extensions.FindString(extension.c_str()) >= 0;
}

GDALDriver* find_driver(const std::string& extension) {
  start_gdal();
  const GdalErrors errors;
  GDALAllRegister();
  GDALDriverManager& drivers = *GetGDALDriverManager();
  for (const Format& format : formats) {
    if (format.extension == extension) return drivers.GetDriverByName(format.driver);
  }
  for (int i = 0; i < drivers.GetDriverCount(); ++i) {
    if (!extension.empty() && writes(*drivers.GetDriver(i), extension)) return drivers.GetDriver(i);
  }
  return nullptr;
}

std::string known_extensions() {
  std::string text = ".geojson, .json";
  for (const Format& format : formats) text += ", ." + std::string(format.extension);
  return text;
}

[[noreturn]] void refuse(const std::string& path, const std::string& text) {
  throw Error(Message{path, 0, text, "cells are written to " + known_extensions()});
}

GDALDriver& require_driver(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension.empty()) refuse(path, "the extension tells the format, and there is none");
  GDALDriver* driver = find_driver(extension);
  if (driver == nullptr)
    refuse(path, "no format of cells has the extension ." + printable(extension));
  return *driver;
}

/// Fixes the date that GDAL writes for as long as it lives, so that the same cells make the same
/// bytes on any day.
class FixedDate {
 public:
  FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", "1970-01-01T00:00:00.000Z"); }
  ~FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr); }
  FixedDate(const FixedDate&) = delete;
  FixedDate& operator=(const FixedDate&) = delete;
};

OGRFieldType ogr_type(FieldType type) {
  if (type == FieldType::integer) return OFTInteger64;
  return type == FieldType::real ? OFTReal : OFTString;
}

/// Writes the cells into one layer of GDAL's.
class LayerWriter {
 public:
  LayerWriter(const CellFeatures& features, const std::string& path)
      : features_(features), path_(path), attributes_(attribute_fields(features)), folder_(path) {}

  std::vector<EncodedFile> write(GDALDriver& driver, std::span<const MultiPolygon> shapes,
                                 const std::optional<Crs>& crs) {
    const FixedDate date;
    std::unique_ptr<GDALDataset> dataset(
        driver.Create(folder_.file().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    check(dataset != nullptr);
    OGRLayer& layer = create_layer(*dataset, crs);
    for (std::size_t i = 0; i < shapes.size(); ++i) add(layer, features_.cells[i], shapes[i]);
    dataset.reset();
    check(true);
    std::vector<EncodedFile> files = folder_.take();
    require_valid_after_rounding(driver.GetDescription());
    return files;
  }

 private:
  void require_valid_after_rounding(const std::string& driver) const {
    const auto fault = fault_after_rounding(folder_.file(), driver);
    if (!fault || fault->feature >= features_.cells.size()) return;
    throw Error(Message{path_, 0,
                        "the format rounds coordinates so that the cell of station " +
                            quoted(features_.cells[fault->feature].station, 80) +
                            " is no valid shape: " + fault->reason,
                        "a .gpkg keeps every digit"});
  }

  void check(bool done) const {
    if (!done || errors_.failed())
      throw Error(Message{path_, 0, "GDAL cannot write it: " + errors_.text(), {}});
    if (errors_.first_warning().find("truncated") != std::string::npos) {
      throw Error(Message{path_, 0, "the format is too narrow: " + errors_.first_warning(),
                          "a .gpkg holds texts of any length"});
    }
  }

  OGRLayer& create_layer(GDALDataset& dataset, const std::optional<Crs>& crs) {
    CPLStringList options;
    const std::string driver = dataset.GetDriverName();
    if (driver == "CSV") options.SetNameValue("GEOMETRY", "AS_WKT");
    // FlatGeobuf's index would put the cells into another order.
    if (driver == "FlatGeobuf") options.SetNameValue("SPATIAL_INDEX", "NO");
    if (driver == "ESRI Shapefile") options.SetNameValue("DBF_DATE_LAST_UPDATE", "1970-01-01");
    if (driver == "ESRI Shapefile") options.SetNameValue("ENCODING", "UTF-8");
    std::unique_ptr<OGRSpatialReference> system;
    if (crs) system.reset(crs->definition().system.Clone());
    OGRLayer* layer = dataset.CreateLayer("cells", system.get(), wkbMultiPolygon, options.List());
    check(layer != nullptr);
    add_field(*layer, "station", OFTString);
    if (has_basins()) add_field(*layer, "basin", OFTString);
    add_field(*layer, features_.area_column, OFTReal);
    add_field(*layer, "weight", OFTReal);
    if (features_.has_rainfall) add_field(*layer, "rainfall", OFTReal);
    for (const FieldName& field : attributes_) add_field(*layer, field.name, ogr_type(field.type));
    return *layer;
  }

  bool has_basins() const {
    return !features_.cells.empty() && features_.cells[0].basin.has_value();
  }

  void add_field(OGRLayer& layer, const std::string& name, OGRFieldType type) const {
    OGRFieldDefn field(name.c_str(), type);
    // Where a format states widths, fields must be wide enough for any double's digits.
    if (type == OFTReal && narrow_numbers()) {
      field.SetWidth(24);
      field.SetPrecision(15);
    }
    check(layer.CreateField(&field) == OGRERR_NONE);
  }

  bool narrow_numbers() const {
    return extension_of(path_) == "shp" || extension_of(path_) == "shz";
  }

  void add(OGRLayer& layer, const CellFeature& cell, const MultiPolygon& shape) {
    const std::unique_ptr<OGRFeature, void (*)(OGRFeature*)> feature(
        OGRFeature::CreateFeature(layer.GetLayerDefn()), OGRFeature::DestroyFeature);
    feature->SetGeometryDirectly(ogr_shape(shape).release());
    int field = 0;
    feature->SetField(field++, cell.station.c_str());
    if (has_basins()) feature->SetField(field++, cell.basin.value_or("").c_str());
    feature->SetField(field++, cell.area);
    feature->SetField(field++, cell.weight);
    if (features_.has_rainfall && std::isfinite(cell.rainfall))
      feature->SetField(field, cell.rainfall);
    if (features_.has_rainfall) ++field;
    for (std::size_t i = 0; i < attributes_.size(); ++i) {
      set(*feature, field++, features_.attributes->rows[cell.attribute_row][i],
          attributes_[i].type);
    }
    check(layer.CreateFeature(feature.get()) == OGRERR_NONE);
  }

  static void set(OGRFeature& feature, int field, const std::string& text, FieldType type) {
    if (text.empty()) return;
    if (type == FieldType::real) {
      feature.SetField(field, parse_number(text).value);
    } else {
      feature.SetField(field, text.c_str());
    }
  }

  const CellFeatures& features_;
  const std::string& path_;
  std::vector<FieldName> attributes_;
  MemoryFolder folder_;
  GdalErrors errors_;
};

}  // namespace

std::string extension_of(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  return dot == std::string::npos || path[dot] == '/' ? "" : lower_case(path.substr(dot + 1));
}

void require_cells_driver(const std::string& path) {
  require_driver(path);
}

std::vector<EncodedFile> write_cells_layer(const CellFeatures& features,
                                           std::span<const MultiPolygon> shapes,
                                           const std::optional<Crs>& crs, const std::string& path) {
  return LayerWriter(features, path).write(require_driver(path), shapes, crs);
}

}  // namespace thiessen
