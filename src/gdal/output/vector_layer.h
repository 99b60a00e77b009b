#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "gdal/crs/crs.h"
#include "gdal/output/encoded_file.h"
#include "gdal/output/layer_readback.h"
#include "results/provenance.h"
#include "text/attributes.h"

class OGRGeometry;

namespace thiessen {

/// A layer of vectors that is to be written, whatever is in it.
struct VectorLayer {
  enum class Shapes { polygons, lines, points, none };

  std::string name;
  Shapes shapes = Shapes::polygons;
  std::vector<FieldName> fields;
  /// How many fields, from the first on, are this program's own: an empty text of theirs is a text,
  /// and no lack of a value.
  std::size_t own_fields = 0;
  /// The values, with the names of `fields`.
  LayerTexts values;
  /// The shape of a row; null where it has none.
  std::function<std::unique_ptr<OGRGeometry>(std::size_t row)> shape;
  /// How a row is drawn, in OGR's style language, where the format can say it.
  std::function<std::string(std::size_t row)> style{};
  std::optional<Provenance> made_by{};
  /// Asked when the file is written, with its place in memory and the driver's name: throws Error
  /// where it is not as it should be.
  std::function<void(const std::string& written, const std::string& driver)> prove{};
};

/// Encodes a layer in the format of `path`'s extension, with what makes files of each driver whole,
/// equal every time and honest: options, types and widths of fields, what GDAL warns of, and values
/// read back where a format may cut them. The first file is that of `path`; others lie beside it.
/// `older` holds the bytes of a GeoPackage whose other layers are kept; it is empty where there is
/// none. GeoJSON is WGS 84 (RFC 7946) where the CRS is known.
///
/// What GDAL warns of, and fields that the format calls otherwise, go to `warnings`. Throws Error
/// where there is no such format, and where it cannot hold a value whole.
std::vector<EncodedFile> write_vector_layer(const VectorLayer& layer, const std::optional<Crs>& crs,
                                            const std::string& path, const std::string& older,
                                            Warnings& warnings);

}  // namespace thiessen
