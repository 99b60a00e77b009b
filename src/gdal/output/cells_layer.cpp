#include "gdal/output/cells_layer.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include "base/interrupt.h"
#include "base/number.h"
#include "base/utf8.h"
#include "gdal/crs/crs_definition.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_conversion.h"
#include "gdal/output/fixed_date.h"
#include "gdal/output/layer_readback.h"
#include "gdal/output/memory_files.h"
#include "gdal/output/written_validity.h"

namespace thiessen {
namespace {

constexpr const char* layer_name = "cells";

/// Which texts a driver's files hold without a limit of their length, names and letters.
bool holds_any_text(std::string_view driver) {
  constexpr std::array<std::string_view, 3> drivers = {"GPKG", "FlatGeobuf", "PGDUMP"};
  return std::find(drivers.begin(), drivers.end(), driver) != drivers.end();
}

bool is_of_renaming(std::string_view warning) {
  return warning.find("laundered") != std::string_view::npos;
}

bool is_of_loss(std::string_view warning) {
  constexpr std::array<std::string_view, 3> signs = {"truncated", "not successfully written",
                                                     "couldn't be converted"};
  return std::any_of(signs.begin(), signs.end(), [&](std::string_view sign) {
    return warning.find(sign) != std::string_view::npos;
  });
}

/// Writes the cells into one layer of GDAL's.
class LayerWriter {
 public:
  LayerWriter(const CellFeatures& features, const std::string& path, Warnings& warnings)
      : features_(features), path_(path), warnings_(warnings), folder_(path) {
    fields_.push_back({"station", FieldType::text});
    if (has_basins()) fields_.push_back({"basin", FieldType::text});
    fields_.push_back({features_.area_column, FieldType::real});
    fields_.push_back({"weight", FieldType::real});
    if (features_.has_rainfall) fields_.push_back({"rainfall", FieldType::real});
    own_fields_ = fields_.size();
    const std::vector<FieldName> attributes = attribute_fields(features_);
    fields_.insert(fields_.end(), attributes.begin(), attributes.end());
  }

  std::vector<EncodedFile> write(GDALDriver& driver, std::span<const MultiPolygon> shapes,
                                 const std::optional<Crs>& crs, const std::string& older) {
    const FixedDate date;
    dataset_ = older.empty() ? create(driver) : open(driver, older);
    OGRLayer& layer = create_layer(crs);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      throw_if_interrupted();
      add(layer, features_.cells[i], shapes[i]);
    }
    dataset_.reset();
    check(true);
    const std::string name = driver.GetDescription();
    if (!holds_any_text(name)) require_read_back(driver, folder_.file(), texts(), path_, warnings_);
    require_no_loss();
    std::vector<EncodedFile> files = folder_.take();
    require_valid_after_rounding(name);
    tell_warnings();
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
  }

  /// Requires that GDAL warned of no loss. It is asked last, for reading back tells more of it.
  void require_no_loss() const {
    for (const std::string& warning : errors_.warnings()) {
      if (!is_of_loss(warning)) continue;
      throw Error(Message{path_, 0, "the format is too narrow: " + warning,
                          "a .gpkg holds texts of any length and numbers of any size"});
    }
  }

  std::unique_ptr<GDALDataset> create(GDALDriver& driver) const {
    CPLStringList options;
    if (driver.GetDescription() == std::string_view("GML") && features_.made_by)
      options.SetNameValue("DESCRIPTION", sentence_of(*features_.made_by).c_str());
    std::unique_ptr<GDALDataset> dataset(
        driver.Create(folder_.file().c_str(), 0, 0, 0, GDT_Unknown, options.List()));
    check(dataset != nullptr);
    return dataset;
  }

  /// Opens the older dataset without its layer of cells.
  std::unique_ptr<GDALDataset> open(GDALDriver& driver, const std::string& older) const {
    folder_.put(older);
    const char* drivers[] = {driver.GetDescription(), nullptr};
    std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(
        folder_.file().c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE, drivers, nullptr, nullptr));
    check(dataset != nullptr);
    for (int i = dataset->GetLayerCount() - 1; i >= 0; --i) {
      if (lower_case(dataset->GetLayer(i)->GetName()) == layer_name)
        check(dataset->DeleteLayer(i) == OGRERR_NONE);
    }
    return dataset;
  }

  /// A name for a column of the format's own that no field has.
  std::string free_name(std::string name) const {
    const auto is_taken = [&](const FieldName& field) { return lower_case(field.name) == name; };
    while (std::any_of(fields_.begin(), fields_.end(), is_taken)) name += '_';
    return name;
  }

  /// SQLite's reader takes a column of this name for the number of the feature.
  void require_no_number_of_sqlite() const {
    for (const FieldName& field : fields_) {
      if (lower_case(field.name) != "ogc_fid") continue;
      throw Error(Message{path_, 0,
                          "the field " + quoted(field.name, 80) +
                              " cannot be written: the format keeps that name for itself",
                          "a .gpkg holds fields of any name"});
    }
  }

  bool is_ascii() const {
    for (const CellFeature& cell : features_.cells) {
      for (std::size_t i = 0; i < fields_.size(); ++i) {
        const std::string& bytes = text(cell, i);
        if (std::any_of(bytes.begin(), bytes.end(),
                        [](char c) { return static_cast<unsigned char>(c) > 127; }))
          return false;
      }
    }
    return true;
  }

  CPLStringList layer_options(std::string_view driver) const {
    CPLStringList options;
    if (driver == "CSV") options.SetNameValue("GEOMETRY", "AS_WKT");
    if (driver == "ESRI Shapefile") options.SetNameValue("DBF_DATE_LAST_UPDATE", "1970-01-01");
    // MapInfo's own name for UTF-8 is not known to GDAL, which warns of that.
    if (driver == "ESRI Shapefile" || (driver == "MapInfo File" && !is_ascii()))
      options.SetNameValue("ENCODING", "UTF-8");
    if (driver == "GPKG") {
      options.SetNameValue("FID", free_name("fid").c_str());
      options.SetNameValue("GEOMETRY_NAME", free_name("geom").c_str());
    }
    if (driver == "SQLite" || driver == "PGDUMP") {
      options.SetNameValue("LAUNDER", "NO");
      options.SetNameValue("FID", free_name("ogc_fid").c_str());
    }
    if (driver == "SQLite") {
      require_no_number_of_sqlite();
      options.SetNameValue("GEOMETRY_NAME", free_name("geometry").c_str());
    }
    if (driver == "PGDUMP") {
      options.SetNameValue("GEOMETRY_NAME", free_name("wkb_geometry").c_str());
      // Whoever runs the script decides about a table that is there: its CREATE fails.
      options.SetNameValue("DROP_TABLE", "NO");
      if (features_.made_by)
        options.SetNameValue("DESCRIPTION", sentence_of(*features_.made_by).c_str());
    }
    return options;
  }

  OGRLayer& create_layer(const std::optional<Crs>& crs) {
    const std::string driver = dataset_->GetDriverName();
    std::unique_ptr<OGRSpatialReference> system;
    if (crs) system.reset(crs->definition().system.Clone());
    OGRLayer* layer = dataset_->CreateLayer(layer_name, system.get(), wkbMultiPolygon,
                                            layer_options(driver).List());
    check(layer != nullptr);
    for (std::size_t i = 0; i < fields_.size(); ++i) add_field(*layer, i);
    if (driver == "GPKG" && features_.made_by) {
      for (const auto& [name, value] : items_of(*features_.made_by))
        layer->SetMetadataItem(name.c_str(), value.c_str());
    }
    return *layer;
  }

  bool has_basins() const {
    return !features_.cells.empty() && features_.cells[0].basin.has_value();
  }

  void add_field(OGRLayer& layer, std::size_t field) {
    const FieldName& wanted = fields_[field];
    OGRFieldDefn definition(wanted.name.c_str(), type_of(field));
    // Where a format states widths, fields must be wide enough for any double's digits.
    if (wanted.type == FieldType::real && narrow_numbers()) {
      definition.SetWidth(24);
      definition.SetPrecision(15);
    }
    check(layer.CreateField(&definition) == OGRERR_NONE);
  }

  bool narrow_numbers() const {
    return extension_of(path_) == "shp" || extension_of(path_) == "shz";
  }

  /// The type as which the format holds a field.
  OGRFieldType type_of(std::size_t field) {
    switch (fields_[field].type) {
      case FieldType::text:
        return OFTString;
      case FieldType::real:
        return OFTReal;
      case FieldType::integer:
        break;
    }
    const char* types = dataset_->GetDriver()->GetMetadataItem(GDAL_DMD_CREATIONFIELDDATATYPES);
    if (types == nullptr || std::string_view(types).find("Integer64") != std::string_view::npos)
      return OFTInteger64;
    if (is_short(field)) return OFTInteger;
    warnings_.add({path_,
                   0,
                   "the field " + quoted(fields_[field].name, 80) +
                       " is written as text: whole numbers of the format end at " +
                       std::to_string(std::numeric_limits<std::int32_t>::max()),
                   {}});
    return OFTString;
  }

  bool is_short(std::size_t field) const {
    return std::all_of(
        features_.cells.begin(), features_.cells.end(), [&](const CellFeature& cell) {
          const auto value = parse_number(text(cell, field));
          return !value || std::abs(value.value) <= std::numeric_limits<std::int32_t>::max();
        });
  }

  void add(OGRLayer& layer, const CellFeature& cell, const MultiPolygon& shape) {
    const std::unique_ptr<OGRFeature, void (*)(OGRFeature*)> feature(
        OGRFeature::CreateFeature(layer.GetLayerDefn()), OGRFeature::DestroyFeature);
    feature->SetGeometryDirectly(ogr_shape(shape).release());
    for (std::size_t i = 0; i < fields_.size(); ++i) set(*feature, cell, i);
    check(layer.CreateFeature(feature.get()) == OGRERR_NONE);
  }

  void set(OGRFeature& feature, const CellFeature& cell, std::size_t field) const {
    const int at = static_cast<int>(field);
    if (fields_[field].type == FieldType::real) {
      if (const auto value = number(cell, field)) feature.SetField(at, *value);
      return;
    }
    const std::string& value = text(cell, field);
    if (field < own_fields_ || !value.empty()) feature.SetField(at, value.c_str());
  }

  /// The text of a field that is no number of our own; empty for such a one.
  const std::string& text(const CellFeature& cell, std::size_t field) const {
    static const std::string none;
    if (field == 0) return cell.station;
    if (field == 1 && cell.basin) return *cell.basin;
    if (field < own_fields_) return none;
    return features_.attributes->rows[cell.attribute_row][field - own_fields_];
  }

  LayerTexts texts() const {
    LayerTexts wanted;
    wanted.rows = features_.cells.size();
    for (const FieldName& field : fields_) wanted.names.push_back(field.name);
    wanted.text = [&](std::size_t row, std::size_t field) {
      return fields_[field].type == FieldType::real ? std::string()
                                                    : text(features_.cells[row], field);
    };
    wanted.number = [&](std::size_t row, std::size_t field) {
      return fields_[field].type == FieldType::real ? number(features_.cells[row], field)
                                                    : std::nullopt;
    };
    return wanted;
  }

  /// The number of a field of numbers; nothing where the cell has none, or what is none, as the NaN
  /// of another file.
  std::optional<double> number(const CellFeature& cell, std::size_t field) const {
    const std::string& name = fields_[field].name;
    if (field >= own_fields_) {
      const auto parsed = parse_number(text(cell, field));
      return parsed ? std::optional(parsed.value) : std::nullopt;
    }
    if (name == features_.area_column) return cell.area;
    if (name == "weight") return cell.weight;
    return std::isfinite(cell.rainfall) ? std::optional(cell.rainfall) : std::nullopt;
  }

  /// Tells what GDAL warned of, but for new names of fields, which are told already.
  void tell_warnings() {
    for (const std::string& warning : errors_.warnings()) {
      if (!is_of_renaming(warning)) warnings_.add({path_, 0, "GDAL warns: " + warning, {}});
    }
  }

  const CellFeatures& features_;
  const std::string& path_;
  Warnings& warnings_;
  std::vector<FieldName> fields_;
  std::size_t own_fields_ = 0;  ///< how many of them are not the station's attributes
  MemoryFolder folder_;
  GdalErrors errors_;
  std::unique_ptr<GDALDataset> dataset_;
};

}  // namespace

void require_cells_driver(const std::string& path) {
  require_vector_driver(path);
}

std::vector<EncodedFile> write_cells_layer(const CellFeatures& features,
                                           std::span<const MultiPolygon> shapes,
                                           const std::optional<Crs>& crs, const std::string& path,
                                           const std::string& older, Warnings& warnings) {
  return LayerWriter(features, path, warnings)
      .write(require_vector_driver(path), shapes, crs, older);
}

}  // namespace thiessen
