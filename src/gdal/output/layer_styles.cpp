#include "gdal/output/layer_styles.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <array>
#include <memory>

#include "base/error.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/output/fixed_date.h"
#include "gdal/output/memory_files.h"

namespace thiessen {
namespace {

constexpr const char* table_name = "layer_styles";

struct Column {
  const char* name;
  OGRFieldType type = OFTString;
  OGRFieldSubType subtype = OFSTNone;
};

/// The columns by which QGIS knows the table.
constexpr std::array columns{Column{"f_table_catalog"},
                             Column{"f_table_schema"},
                             Column{"f_table_name"},
                             Column{"f_geometry_column"},
                             Column{"styleName"},
                             Column{"styleQML"},
                             Column{"styleSLD"},
                             Column{"useAsDefault", OFTInteger, OFSTBoolean},
                             Column{"description"},
                             Column{"owner"},
                             Column{"ui"},
                             Column{"update_time", OFTDateTime}};

/// Writes the table of one GeoPackage.
class StylesWriter {
 public:
  explicit StylesWriter(const std::string& path) : path_(path), folder_(path) {}

  std::string write(const std::string& geopackage, std::span<const LayerStyle> styles) {
    const FixedDate date;
    folder_.put(geopackage);
    const std::array<const char*, 2> drivers{"GPKG", nullptr};
    std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(
        folder_.file().c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE, drivers.data(), nullptr, nullptr));
    check(dataset != nullptr);
    OGRLayer& table = table_of(*dataset);
    remove(table, styles);
    for (const LayerStyle& style : styles) add(*dataset, table, style);
    dataset.reset();
    check(true);
    return std::move(folder_.take().front().bytes);
  }

 private:
  void check(bool done) const {
    if (!done || errors_.failed())
      throw Error(Message{path_, 0, "GDAL cannot write its styles: " + errors_.text(), {}});
  }

  OGRLayer& table_of(GDALDataset& dataset) const {
    if (OGRLayer* const there = dataset.GetLayerByName(table_name)) return *there;
    std::array<char*, 1> none{nullptr};
    OGRLayer* const made = dataset.CreateLayer(table_name, nullptr, wkbNone, none.data());
    check(made != nullptr);
    for (const Column& column : columns) {
      OGRFieldDefn definition(column.name, column.type);
      definition.SetSubType(column.subtype);
      check(made->CreateField(&definition) == OGRERR_NONE);
    }
    return *made;
  }

  void remove(OGRLayer& table, std::span<const LayerStyle> styles) const {
    const int name = table.FindFieldIndex("f_table_name", 1);
    check(name >= 0);
    std::vector<GIntBig> replaced;
    for (const auto& feature : table) {
      for (const LayerStyle& style : styles) {
        if (style.layer == feature->GetFieldAsString(name)) replaced.push_back(feature->GetFID());
      }
    }
    for (const GIntBig number : replaced) check(table.DeleteFeature(number) == OGRERR_NONE);
  }

  void add(GDALDataset& dataset, OGRLayer& table, const LayerStyle& style) const {
    OGRLayer* const styled = dataset.GetLayerByName(style.layer.c_str());
    check(styled != nullptr);
    const std::unique_ptr<OGRFeature, void (*)(OGRFeature*)> feature(
        OGRFeature::CreateFeature(table.GetLayerDefn()), OGRFeature::DestroyFeature);
    const auto set = [&](const char* field, const std::string& text) {
      feature->SetField(field, text.c_str());
    };
    set("f_table_catalog", "");
    set("f_table_schema", "");
    set("f_table_name", style.layer);
    set("f_geometry_column", styled->GetGeometryColumn());
    set("styleName", style.layer);
    set("styleQML", style.style);
    set("styleSLD", "");
    feature->SetField("useAsDefault", 1);
    set("description", "made by thiessen");
    set("owner", "");
    feature->SetField("update_time", 1970, 1, 1, 0, 0, 0.0F, 100);
    check(table.CreateFeature(feature.get()) == OGRERR_NONE);
  }

  const std::string& path_;
  MemoryFolder folder_;
  GdalErrors errors_;
};

}  // namespace

std::string with_layer_styles(const std::string& geopackage, std::span<const LayerStyle> styles,
                              const std::string& path) {
  start_gdal();
  return StylesWriter(path).write(geopackage, styles);
}

}  // namespace thiessen
