#include "gdal/output/vector_layer.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "base/interrupt.h"
#include "base/number.h"
#include "base/utf8.h"
#include "gdal/crs/crs_definition.h"
#include "gdal/gdal_errors.h"
#include "gdal/output/fixed_date.h"
#include "gdal/output/layer_formats.h"
#include "gdal/output/layer_options.h"
#include "gdal/output/memory_files.h"
#include "gdal/output/spatial_index.h"

namespace thiessen {
namespace {

/// Which drivers' files hold texts without a limit of their length, names and letters.
bool holds_any_text(std::string_view driver) {
  constexpr std::array<std::string_view, 4> drivers = {"GPKG", "FlatGeobuf", "PGDUMP", "GeoJSON"};
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

OGRwkbGeometryType type_of_shapes(VectorLayer::Shapes shapes) {
  switch (shapes) {
    case VectorLayer::Shapes::polygons:
      return wkbMultiPolygon;
    case VectorLayer::Shapes::lines:
      return wkbMultiLineString;
    case VectorLayer::Shapes::points:
      return wkbPoint;
    case VectorLayer::Shapes::none:
      break;
  }
  return wkbNone;
}

/// Has SQLite hear Ctrl-C between two of its steps: a GeoPackage's index is made when the file is
/// closed, at once, and takes as long as all before.
void hear_interrupts(GDALDataset& dataset) {
  constexpr int steps = 10'000;
  constexpr std::string_view driver = "GPKG";
  if (dataset.GetDriverName() != driver) return;
  auto* const database = static_cast<sqlite3*>(dataset.GetInternalHandle("SQLITE_HANDLE"));
  if (database == nullptr) return;
  sqlite3_progress_handler(
      database, steps, [](void*) { return interrupt_signal() != 0 ? 1 : 0; }, nullptr);
}

/// Writes one layer of GDAL's.
class LayerWriter {
 public:
  LayerWriter(const VectorLayer& layer, const std::string& path, Warnings& warnings)
      : layer_(layer), path_(path), warnings_(warnings), folder_(path) {}

  std::vector<EncodedFile> write(GDALDriver& driver, const std::optional<Crs>& crs,
                                 const std::string& older) {
    const FixedDate date;
    dataset_ = older.empty() ? create(driver) : open(driver, older);
    const bool in_one = dataset_->TestCapability(ODsCTransactions) != FALSE;
    hear_interrupts(*dataset_);
    OGRLayer& written = create_layer(crs);
    // Else each row is a transaction of its own, and a file that is not whole is never seen.
    if (in_one) check(dataset_->StartTransaction() == OGRERR_NONE);
    for (std::size_t row = 0; row < layer_.values.rows; ++row) {
      throw_if_interrupted();
      add(written, row);
    }
    if (index_) index_->write();
    if (in_one) check(dataset_->CommitTransaction() == OGRERR_NONE);
    index_.reset();
    dataset_.reset();
    throw_if_interrupted();
    check(true);
    const std::string name = driver.GetDescription();
    if (!holds_any_text(name) && layer_.values.rows > 0)
      require_read_back(driver, folder_.file(), layer_.values, path_, warnings_);
    require_no_loss();
    std::vector<EncodedFile> files = folder_.take();
    if (layer_.prove) layer_.prove(folder_.file(), name);
    tell_warnings();
    return files;
  }

 private:
  void check(bool done) const {
    if (done && !errors_.failed()) return;
    throw_if_interrupted();  // which makes SQLite fail
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

  /// Options need no proof, for which GDAL reads JSON files by a library that crashes where there
  /// is no memory.
  std::unique_ptr<GDALDataset> create(GDALDriver& driver) const {
    const CPLConfigOptionSetter no_proof("GDAL_VALIDATE_CREATION_OPTIONS", "NO", false);
    std::unique_ptr<GDALDataset> dataset(
        driver.Create(folder_.file().c_str(), 0, 0, 0, GDT_Unknown,
                      file_options(layer_, driver.GetDescription()).List()));
    check(dataset != nullptr);
    return dataset;
  }

  /// Opens the older dataset without its layer of the same name.
  std::unique_ptr<GDALDataset> open(GDALDriver& driver, const std::string& older) const {
    folder_.put(older);
    const char* drivers[] = {driver.GetDescription(), nullptr};
    std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(
        folder_.file().c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE, drivers, nullptr, nullptr));
    check(dataset != nullptr);
    for (int i = dataset->GetLayerCount() - 1; i >= 0; --i) {
      if (lower_case(dataset->GetLayer(i)->GetName()) == layer_.name)
        check(dataset->DeleteLayer(i) == OGRERR_NONE);
    }
    return dataset;
  }

  OGRLayer& create_layer(const std::optional<Crs>& crs) {
    const std::string driver = dataset_->GetDriverName();
    std::unique_ptr<OGRSpatialReference> system;
    if (crs) {
      system.reset(crs->definition().system.Clone());
    } else if (driver == "GPKG") {
      // By this name a GeoPackage knows a plane; without one it would have unknown degrees.
      system = std::make_unique<OGRSpatialReference>();
      system->SetLocalCS("Undefined Cartesian SRS");
    }
    const bool has_shapes = layer_.shapes != VectorLayer::Shapes::none;
    OGRLayer* layer = dataset_->CreateLayer(
        layer_.name.c_str(), has_shapes ? system.get() : nullptr, type_of_shapes(layer_.shapes),
        layer_options(layer_, driver, crs.has_value(), path_).List());
    check(layer != nullptr);
    for (std::size_t i = 0; i < layer_.fields.size(); ++i) add_field(*layer, i);
    if (driver == "GPKG" && layer_.made_by) {
      for (const auto& [name, value] : items_of(*layer_.made_by))
        layer->SetMetadataItem(name.c_str(), value.c_str());
    }
    if (driver == "GPKG" && has_shapes) index_.emplace(*dataset_, *layer, path_);
    return *layer;
  }

  void add_field(OGRLayer& layer, std::size_t field) {
    const FieldName& wanted = layer_.fields[field];
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
    switch (layer_.fields[field].type) {
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
                   "the field " + quoted(layer_.fields[field].name, 80) +
                       " is written as text: whole numbers of the format end at " +
                       std::to_string(std::numeric_limits<std::int32_t>::max()),
                   {}});
    return OFTString;
  }

  bool is_short(std::size_t field) const {
    for (std::size_t row = 0; row < layer_.values.rows; ++row) {
      const auto value = parse_number(layer_.values.text(row, field));
      if (value && std::abs(value.value) > std::numeric_limits<std::int32_t>::max()) return false;
    }
    return true;
  }

  void add(OGRLayer& layer, std::size_t row) {
    const std::unique_ptr<OGRFeature, void (*)(OGRFeature*)> feature(
        OGRFeature::CreateFeature(layer.GetLayerDefn()), OGRFeature::DestroyFeature);
    OGREnvelope extent;
    if (auto shape = layer_.shape(row)) {
      if (!shape->IsEmpty()) shape->getEnvelope(&extent);
      feature->SetGeometryDirectly(shape.release());
    }
    for (std::size_t i = 0; i < layer_.fields.size(); ++i) set(*feature, row, i);
    if (layer_.style) feature->SetStyleString(layer_.style(row).c_str());
    check(layer.CreateFeature(feature.get()) == OGRERR_NONE);
    if (index_ && extent.IsInit())
      index_->add(feature->GetFID(), {{extent.MinX, extent.MinY}, {extent.MaxX, extent.MaxY}});
  }

  void set(OGRFeature& feature, std::size_t row, std::size_t field) const {
    const int at = static_cast<int>(field);
    if (layer_.fields[field].type == FieldType::real) {
      if (const auto value = layer_.values.number(row, field)) feature.SetField(at, *value);
      return;
    }
    const std::string value = layer_.values.text(row, field);
    if (field < layer_.own_fields || !value.empty()) feature.SetField(at, value.c_str());
  }

  /// Tells what GDAL warned of, but for new names of fields, which are told already.
  void tell_warnings() {
    for (const std::string& warning : errors_.warnings()) {
      if (!is_of_renaming(warning)) warnings_.add({path_, 0, "GDAL warns: " + warning, {}});
    }
  }

  const VectorLayer& layer_;
  const std::string& path_;
  Warnings& warnings_;
  MemoryFolder folder_;
  GdalErrors errors_;
  std::unique_ptr<GDALDataset> dataset_;
  std::optional<SpatialIndex> index_;
};

}  // namespace

std::vector<EncodedFile> write_vector_layer(const VectorLayer& layer, const std::optional<Crs>& crs,
                                            const std::string& path, const std::string& older,
                                            Warnings& warnings) {
  return LayerWriter(layer, path, warnings).write(require_vector_driver(path), crs, older);
}

}  // namespace thiessen
