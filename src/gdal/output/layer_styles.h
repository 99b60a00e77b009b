#pragma once

#include <span>
#include <string>

namespace thiessen {

/// How QGIS is to show a layer.
struct LayerStyle {
  std::string layer;  ///< its name
  std::string style;  ///< QGIS's XML
};

/// Puts styles into a GeoPackage, where QGIS finds them when it opens a layer: in its table
/// `layer_styles`, as the layers' default. Styles that are there for these layers are replaced, and
/// those of other layers stay. The date in the table is fixed, so that the same styles make the
/// same bytes. `path` is the file's name in messages. Throws Error where SQLite or GDAL fails.
std::string with_layer_styles(const std::string& geopackage, std::span<const LayerStyle> styles,
                              const std::string& path);

}  // namespace thiessen
