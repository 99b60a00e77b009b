#include "cli/outputs/encoded_files.h"

#include <algorithm>

#include "gdal/output/layer_formats.h"
#include "gdal/output/side_files.h"

namespace thiessen::cli {

void append_files(Outputs& outputs, OutputFile& file, const std::vector<EncodedFile>& encoded) {
  file.append(encoded.front().bytes);
  append_side_files(outputs, encoded);
}

void append_side_files(Outputs& outputs, const std::vector<EncodedFile>& encoded) {
  for (std::size_t i = 1; i < encoded.size(); ++i)
    outputs.add(encoded[i].name).append(encoded[i].bytes);
  for (const std::string& name : side_files_of(encoded.front().name)) {
    const auto is_it = [&](const EncodedFile& one) { return one.name == name; };
    if (std::none_of(encoded.begin(), encoded.end(), is_it)) outputs.remove(name);
  }
}

std::unique_ptr<GeoPackageCopy> older_layers(const std::string& path) {
  return extension_of(path) == "gpkg" ? copy_of_geopackage(path) : nullptr;
}

void remove_side_files(Outputs& outputs, const std::string& path) {
  for (const std::string& name : side_files_of(path)) outputs.remove(name);
}

}  // namespace thiessen::cli
