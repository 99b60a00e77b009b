#include "gdal/layers/layer.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <utility>

#include "base/enumeration.h"
#include "base/error.h"
#include "base/number.h"
#include "base/secrets.h"
#include "base/utf8.h"
#include "gdal/crs/crs_definition.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_conversion.h"
#include "gdal/layers/opening.h"
#include "gdal/layers/vsi_bytes.h"
#include "gdal/layers/wholeness.h"
#include "text/geojson_audit.h"

namespace thiessen {
namespace {

/// A warning without what it says of GDAL's own options, which nobody can set here.
std::string without_advice(const std::string& warning) {
  return warning.substr(0, warning.find(". To avoid accepting it, set the "));
}

using CrsMember = GeoJsonFindings::CrsMember;

FieldType type_of(OGRFieldType type) {
  if (type == OFTInteger || type == OFTInteger64) return FieldType::integer;
  return type == OFTReal ? FieldType::real : FieldType::text;
}

/// The date in the form of ISO 8601: GDAL separates its numbers by slashes, so 2013/09/11 becomes
/// 2013-09-11.
std::string iso_date(std::string text) {
  std::replace(text.begin(), text.begin() + std::min<std::ptrdiff_t>(10, std::ssize(text)), '/',
               '-');
  return text;
}

std::string text_of(OGRFeature& feature, int field) {
  if (!feature.IsFieldSetAndNotNull(field)) return {};
  switch (feature.GetFieldDefnRef(field)->GetType()) {
    case OFTInteger64:
    case OFTInteger:
      return std::to_string(feature.GetFieldAsInteger64(field));
    case OFTReal: {
      const double value = feature.GetFieldAsDouble(field);
      return value - value == 0 ? shortest_text(value) : feature.GetFieldAsString(field);
    }
    case OFTDate:
    case OFTDateTime:
      return iso_date(feature.GetFieldAsString(field));
    default:
      return feature.GetFieldAsString(field);
  }
}

struct CloseDataset {
  void operator()(GDALDataset* dataset) const {
    const GdalErrors errors;
    GDALClose(dataset);
  }
};

using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// Opens the dataset. An error that GDAL reports is one even where it goes on.
Dataset open(const std::string& file, const Opening& opening, const GdalErrors& errors) {
  std::vector<const char*> drivers = opening.drivers;
  drivers.push_back(nullptr);
  // Dates in GeoJSON are texts and must stay as written; GDAL would reformat them.
  static constexpr const char* options[] = {"DATE_AS_STRING=YES", nullptr};
  const bool geojson = opening.drivers.front() == std::string_view("GeoJSON");
  Dataset dataset(GDALDataset::Open(opening.name.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                                    drivers.data(), geojson ? options : nullptr, nullptr));
  if (!dataset || (errors.failed() && !geojson)) {
    const std::string reason = errors.failed() ? ": " + without_secrets(errors.text(), file) : "";
    throw Error(
        Message{file, 0, "cannot be read as " + std::string(opening.drivers.front()) + reason, {}});
  }
  return dataset;
}

std::string names_of(const std::vector<OGRLayer*>& layers) {
  std::vector<std::string> names;
  names.reserve(layers.size());
  for (OGRLayer* layer : layers) names.emplace_back(layer->GetName());
  return names_up_to(20, names, 80);
}

/// The layers of a dataset. Sheets without a cell and folders without a placemark do not count.
std::vector<OGRLayer*> layers_of(GDALDataset& dataset) {
  std::vector<OGRLayer*> layers;
  for (OGRLayer* layer : dataset.GetLayers()) {
    if (layer->GetLayerDefn()->GetFieldCount() > 0 || layer->GetFeatureCount() != 0) {
      layers.push_back(layer);
    }
  }
  return layers;
}

OGRLayer* choose(GDALDataset& dataset, const std::string& file, const std::string& wanted,
                 const std::string& its_setting) {
  if (!wanted.empty()) {
    if (OGRLayer* layer = dataset.GetLayerByName(wanted.c_str())) return layer;
  }
  const std::vector<OGRLayer*> layers = layers_of(dataset);
  if (!wanted.empty()) {
    throw Error(Message{file, 0, "has no layer " + quoted(wanted, 80),
                        "its layers are " + names_of(layers)});
  }
  if (layers.empty() && dataset.GetLayerCount() > 0) return dataset.GetLayer(0);
  if (layers.empty()) throw Error(Message{file, 0, "has no layer", {}});
  if (layers.size() > 1) {
    throw Error(Message{file, 0, "has several layers: " + names_of(layers),
                        its_setting.empty() ? Wording() : "name one with " + setting(its_setting)});
  }
  return layers[0];
}

bool has_dates(const OGRFeatureDefn& fields) {
  for (int i = 0; i < fields.GetFieldCount(); ++i) {
    if (fields.GetFieldDefn(i)->GetType() == OFTDate) return true;
  }
  return false;
}

/// The reader of .xls gives a cell that shows a date alone without the hours that it holds.
Message hidden_hours(const std::string& file) {
  return {file, 0, "hours of its cells that show a date alone cannot be known",
          "save it as .xlsx if there may be some: of that they are read"};
}

/// The CRS that a layer names. One that GDAL does not understand is none, and noted among the
/// oddities, for the user may know it.
std::unique_ptr<OGRSpatialReference> system_of(OGRLayer& layer,
                                               std::vector<std::string>& oddities) {
  const GdalErrors errors;
  const OGRSpatialReference* system = layer.GetSpatialRef();
  if (system != nullptr) return std::unique_ptr<OGRSpatialReference>(system->Clone());
  if (errors.failed()) oddities.push_back("its CRS is not understood: " + errors.text());
  return nullptr;
}

/// The CRS that a GeoJSON file names. It is read here because GDAL silently takes WGS 84 where it
/// does not know the name.
std::optional<Crs> crs_of(const std::string& file, const GeoJsonFindings& findings) {
  if (findings.crs == CrsMember::other) {
    throw Error(Message{file, 0, "its crs member is neither a name nor a link", {}});
  }
  if (findings.crs != CrsMember::name) return std::nullopt;
  try {
    return Crs::from_text(findings.crs_name, "its crs member");
  } catch (const Error& error) {
    Message message = error.messages().at(0);
    message.file = file;
    throw Error(std::move(message));
  }
}

}  // namespace

struct Layer::Opened {
  std::string file;
  std::string wanted;  ///< the layer that is named, and the setting that names it
  std::string its_setting;
  Opening opening;
  GeoJsonFindings findings;
  bool geojson = false;
  Dataset dataset;
  OGRLayer* layer = nullptr;
  std::unique_ptr<OGRSpatialReference> system;
  bool has_geometry = false;
  std::optional<std::uint64_t> declared;
  Warnings* told = nullptr;
  std::vector<std::string> warnings;
  std::vector<std::string> header;
  std::vector<FieldType> types;
  OGRFeatureUniquePtr feature;
  std::vector<std::string> texts;
  GeometryRecord geometry;
  std::size_t number = 0;
  std::vector<std::string> oddities;
};

Layer::Layer(std::string file, const std::string& layer, const std::string& layer_setting,
             Warnings* warnings)
    : opened_(std::make_unique<Opened>()) {
  Opened& it = *opened_;
  it.told = warnings;
  it.file = std::move(file);
  it.wanted = layer;
  it.its_setting = layer_setting;
  it.opening = find_opening(it.file);
  if (it.opening.drivers.empty()) {
    throw Error(Message{it.file, 0, "is of no kind that GDAL reads here", {}});
  }
  it.geojson = it.opening.drivers.front() == std::string_view("GeoJSON");
  if (it.geojson) {
    VsiBytes bytes(it.file, it.opening.name);
    it.findings = audit_geojson(it.file, bytes);
  }
  if (it.findings.crs == CrsMember::link) {
    it.oddities.push_back("its crs member is a link, which is never followed; WGS 84 is assumed");
  }
  require_whole(it.file, it.opening, it.oddities);
  GdalErrors errors;
  it.dataset = open(it.file, it.opening, errors);
  // Of GeoJSON the audit knows more: its text is whole, and its CRS is read by ourselves.
  if (it.geojson) errors.clear();
  it.layer = choose(*it.dataset, it.file, layer, layer_setting);
  it.declared = declared_features(*it.layer, it.opening);
  const OGRFeatureDefn& fields = *it.layer->GetLayerDefn();
  for (int i = 0; i < fields.GetFieldCount(); ++i) {
    it.header.emplace_back(fields.GetFieldDefn(i)->GetNameRef());
    it.types.push_back(type_of(fields.GetFieldDefn(i)->GetType()));
  }
  if (it.opening.drivers.front() == std::string_view("XLS") && it.told != nullptr &&
      has_dates(fields))
    it.told->add(hidden_hours(it.file));
  it.has_geometry = fields.GetGeomFieldCount() > 0;
  it.system = system_of(*it.layer, it.oddities);
  it.layer->ResetReading();
  if (errors.failed()) throw Error(Message{it.file, 0, "cannot be read: " + errors.text(), {}});
  hear(errors);
}

Layer::~Layer() = default;

const std::string& Layer::file() const {
  return opened_->file;
}
const std::vector<std::string>& Layer::header() const {
  return opened_->header;
}
const std::vector<FieldType>& Layer::types() const {
  return opened_->types;
}
const GeometryRecord& Layer::geometry() const {
  return opened_->geometry;
}
bool Layer::is_geojson() const {
  return opened_->geojson;
}
const std::vector<std::string>& Layer::oddities() const {
  return opened_->oddities;
}

bool Layer::has_geometry() const {
  return opened_->has_geometry;
}

bool Layer::next(Row& row) {
  Opened& it = *opened_;
  if (!it.dataset) return false;
  {
    const GdalErrors errors;
    it.feature.reset(it.layer->GetNextFeature());
    if (errors.failed()) {
      throw Error(
          Message{it.file,
                  0,
                  "feature " + std::to_string(it.number + 1) + " cannot be read: " + errors.text(),
                  {}});
    }
    hear(errors);
  }
  if (!it.feature) {
    finish();
    return false;
  }
  it.texts.clear();
  row.fields.clear();
  for (int i = 0; i < it.feature->GetFieldCount(); ++i) it.texts.push_back(text_of(*it.feature, i));
  row.fields.assign(it.texts.begin(), it.texts.end());
  row.line = ++it.number;
  it.geometry = record_of(it.feature->GetGeometryRef());
  return true;
}

std::unique_ptr<Table> Layer::first_rows() const {
  constexpr std::array<std::string_view, 4> read_on = {"XLS", "GPKG", "ESRI Shapefile",
                                                       "FlatGeobuf"};
  const Opened& it = *opened_;
  if (std::ranges::find(read_on, it.opening.drivers.front()) == read_on.end()) return nullptr;
  return std::make_unique<Layer>(it.file, it.wanted, it.its_setting);
}

void Layer::hear(const GdalErrors& errors) {
  std::vector<std::string>& heard = opened_->warnings;
  for (const std::string& warning : errors.warnings()) {
    // Whoever mends a basin tells of its open rings, and whose they are.
    if (warning.find("Non closed ring") != std::string::npos) continue;
    if (heard.size() < GdalErrors::most_warnings &&
        std::find(heard.begin(), heard.end(), warning) == heard.end()) {
      heard.push_back(warning);
    }
  }
}

// Closes the file, for that may be when GDAL notices what is wrong with it.
void Layer::finish() {
  Opened& it = *opened_;
  if (it.geojson && it.number != it.findings.features) {
    throw Error(Message{it.file,
                        0,
                        "GDAL reads " + std::to_string(it.number) + " of its " +
                            std::to_string(it.findings.features) + " features",
                        {}});
  }
  if (it.declared && it.number != *it.declared) {
    throw Error(Message{it.file,
                        0,
                        "is not whole: it declares " + std::to_string(*it.declared) +
                            " features, and " + std::to_string(it.number) + " can be read",
                        {}});
  }
  const GdalErrors errors;
  GDALClose(it.dataset.release());
  if (errors.failed()) throw Error(Message{it.file, 0, "cannot be read: " + errors.text(), {}});
  hear(errors);
  if (it.told == nullptr) return;
  for (const std::string& warning : it.warnings)
    it.told->add({it.file, 0, "GDAL warns: " + without_advice(warning), {}});
}

std::optional<Crs> Layer::crs() const {
  const Opened& it = *opened_;
  if (it.geojson) return crs_of(it.file, it.findings);
  if (!it.system) return std::nullopt;
  return crs_from_system(*it.system, it.file);
}

bool Layer::crs_implied() const {
  return opened_->geojson &&
         (opened_->findings.crs == CrsMember::absent || opened_->findings.crs == CrsMember::link);
}

}  // namespace thiessen
