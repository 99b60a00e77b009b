#include "gdal/output/kept_layers.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "base/utf8.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/output/memory_files.h"

namespace thiessen {
namespace {

constexpr const char* styles_name = "layer_styles";

bool holds(std::span<const std::string> names, const std::string& name) {
  return std::find(names.begin(), names.end(), lower_case(name)) != names.end();
}

bool is_made_by_a_study(OGRLayer& layer) {
  const char* const software = layer.GetMetadataItem("software");
  return software != nullptr && std::string_view(software).starts_with("thiessen");
}

/// Removes the styles of a layer that is removed. Returns whether that was done.
bool remove_styles(OGRLayer& styles, const std::string& layer) {
  const int name = styles.FindFieldIndex("f_table_name", 1);
  if (name < 0) return true;
  std::vector<GIntBig> numbers;
  for (const auto& feature : styles) {
    if (layer == feature->GetFieldAsString(name)) numbers.push_back(feature->GetFID());
  }
  return std::all_of(numbers.begin(), numbers.end(),
                     [&](GIntBig number) { return styles.DeleteFeature(number) == OGRERR_NONE; });
}

bool is_empty(GDALDataset& dataset) {
  for (auto* layer : dataset.GetLayers()) {
    if (layer->GetName() != std::string_view(styles_name) || layer->GetFeatureCount() > 0)
      return false;
  }
  return true;
}

}  // namespace

std::string kept_layers(const std::string& older, std::span<const std::string> ours,
                        std::span<const std::string> written, const std::string& path,
                        Warnings& warnings) {
  if (older.empty()) return {};
  start_gdal();
  const GdalErrors errors;
  MemoryFolder folder(path);
  folder.put(older);
  const std::array<const char*, 2> drivers{"GPKG", nullptr};
  std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(
      folder.file().c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE, drivers.data(), nullptr, nullptr));
  const auto check = [&](bool done) {
    if (!done) throw Error(Message{path, 0, "GDAL cannot write it anew: " + errors.text(), {}});
  };
  check(dataset != nullptr);
  std::string removed;
  for (int i = dataset->GetLayerCount() - 1; i >= 0; --i) {
    OGRLayer& layer = *dataset->GetLayer(i);
    const std::string name = layer.GetName();
    const bool is_replaced = holds(written, name);
    if (!is_replaced && !(holds(ours, name) && is_made_by_a_study(layer))) continue;
    check(dataset->DeleteLayer(i) == OGRERR_NONE);
    OGRLayer* const styles = dataset->GetLayerByName(styles_name);
    check(styles == nullptr || remove_styles(*styles, name));
    if (!is_replaced) removed += (removed.empty() ? "" : ", ") + quoted(name, 80);
  }
  if (!removed.empty()) {
    warnings.add_notice(
        {path, 0, "layers of an older study that this one does not have are removed: " + removed,
         ""});
  }
  const bool nothing_left = is_empty(*dataset);
  dataset.reset();
  check(!errors.failed());
  return nothing_left ? std::string() : std::move(folder.take().front().bytes);
}

}  // namespace thiessen
