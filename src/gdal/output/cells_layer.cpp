#include "gdal/output/cells_layer.h"

#include <ogr_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "base/colour.h"
#include "base/hexadecimal.h"
#include "base/interrupt.h"
#include "base/number.h"
#include "base/utf8.h"
#include "gdal/layers/geometry_conversion.h"
#include "gdal/output/vector_layer.h"
#include "gdal/output/written_validity.h"
#include "text/csv_writer.h"

namespace thiessen {
namespace {

/// The cells as rows of a layer.
class CellRows {
 public:
  /// `is_named` adds a field `Name`, by which KML's readers call a place, unless the station has
  /// one of its own.
  explicit CellRows(const CellFeatures& features, bool is_named = false) : features_(features) {
    const bool has_basins = !features.cells.empty() && features.cells[0].basin.has_value();
    fields_.push_back({"station", FieldType::text});
    if (has_basins) fields_.push_back({"basin", FieldType::text});
    fields_.push_back({features.area_column, FieldType::real});
    fields_.push_back({"weight", FieldType::real});
    if (features.has_factor) fields_.push_back({"factor", FieldType::real});
    if (features.has_rainfall) fields_.push_back({"rainfall", FieldType::real});
    const std::vector<FieldName> attributes = attribute_fields(features);
    const auto is_name = [](const FieldName& field) { return lower_case(field.name) == "name"; };
    if (is_named && std::none_of(attributes.begin(), attributes.end(), is_name))
      fields_.push_back({"Name", FieldType::text});
    own_fields_ = fields_.size();
    fields_.insert(fields_.end(), attributes.begin(), attributes.end());
  }

  const std::vector<FieldName>& fields() const { return fields_; }
  std::size_t own_fields() const { return own_fields_; }

  LayerTexts values() const {
    LayerTexts values;
    values.rows = features_.cells.size();
    for (const FieldName& field : fields_) values.names.push_back(field.name);
    values.text = [this](std::size_t row, std::size_t field) {
      return fields_[field].type == FieldType::real ? std::string()
                                                    : text(features_.cells[row], field);
    };
    values.number = [this](std::size_t row, std::size_t field) {
      return fields_[field].type == FieldType::real ? number(features_.cells[row], field)
                                                    : std::nullopt;
    };
    return values;
  }

 private:
  /// The text of a field that is no number of our own; empty for such a one.
  const std::string& text(const CellFeature& cell, std::size_t field) const {
    static const std::string none;
    if (field == 0) return cell.station;
    if (field == 1 && cell.basin) return *cell.basin;
    if (field < own_fields_ && fields_[field].name == "Name") return cell.station;
    if (field < own_fields_) return none;
    return features_.attributes->rows[cell.attribute_row][field - own_fields_];
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
    if (name == "factor") return cell.factor;
    return std::isfinite(cell.rainfall) ? std::optional(cell.rainfall) : std::nullopt;
  }

  const CellFeatures& features_;
  std::vector<FieldName> fields_;
  std::size_t own_fields_ = 0;  ///< how many of them are not the station's attributes
};

/// How a cell is drawn: filled so that the ground shows through, with a thin outline.
std::string style_of(Colour colour) {
  std::string text = "BRUSH(fc:#";
  for (const std::uint8_t channel : {colour.red, colour.green, colour.blue})
    append_hexadecimal(text, channel);
  return text + "b0);PEN(c:#404040ff,w:1px)";
}

/// A shape in EWKB: WKB with a sign in the type that an SRID follows it.
std::string ewkb_of(const MultiPolygon& shape, int srid) {
  const std::unique_ptr<OGRMultiPolygon> geometry = ogr_shape(shape);
  std::vector<unsigned char> bytes(geometry->WkbSize());
  geometry->exportToWkb(wkbNDR, bytes.data(), wkbVariantIso);
  constexpr std::size_t order_and_type = 5;
  constexpr unsigned char has_srid = 0x20;  // in the last byte of the type
  bytes[order_and_type - 1] |= has_srid;
  std::array<unsigned char, 4> number{};
  for (std::size_t i = 0; i < number.size(); ++i)
    number.at(i) = static_cast<unsigned char>(static_cast<unsigned>(srid) >> (8 * i));
  bytes.insert(bytes.begin() + order_and_type, number.begin(), number.end());
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const unsigned char byte : bytes) {
    text += digits[byte >> 4U];
    text += digits[byte & 0xFU];
  }
  return text;
}

}  // namespace

std::vector<std::string> append_cell_rows(OutputFile& file, const CellFeatures& features,
                                          std::span<const MultiPolygon> shapes,
                                          const std::string& geometry_name, int srid) {
  const CellRows rows(features);
  const LayerTexts values = rows.values();
  std::vector<std::string> names = values.names;
  names.push_back(geometry_name);
  std::string line;
  for (const std::string& name : names) {
    if (!line.empty()) line += ',';
    append_csv_field(line, name);
  }
  file.append(line + '\n');
  for (std::size_t row = 0; row < values.rows; ++row) {
    throw_if_interrupted();
    line.clear();
    for (std::size_t field = 0; field < rows.fields().size(); ++field) {
      if (rows.fields()[field].type != FieldType::real) {
        append_csv_field(line, values.text(row, field));
      } else if (const auto number = values.number(row, field)) {
        append_shortest(line, *number);
      }
      line += ',';
    }
    if (!shapes[row].empty()) line += ewkb_of(shapes[row], srid);
    file.append(line + '\n');
  }
  return names;
}

bool holds_colours(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == "kml" || extension == "kmz";
}

void require_cells_driver(const std::string& path) {
  require_vector_driver(path);
}

std::vector<EncodedFile> write_cells_layer(const CellFeatures& features,
                                           std::span<const MultiPolygon> shapes,
                                           const std::optional<Crs>& crs, const std::string& path,
                                           const std::string& older, Warnings& warnings) {
  const CellRows rows(features, holds_colours(path));
  VectorLayer layer;
  layer.name = "cells";
  layer.fields = rows.fields();
  layer.own_fields = rows.own_fields();
  layer.values = rows.values();
  layer.shape = [&](std::size_t row) { return ogr_shape(shapes[row]); };
  if (holds_colours(path)) {
    layer.style = [&](std::size_t row) {
      constexpr Colour pale{223, 232, 238};
      return style_of(features.colours.empty() ? pale : features.colours[row]);
    };
  }
  layer.made_by = features.made_by;
  layer.prove = [&](const std::string& written, const std::string& driver) {
    const auto fault = fault_after_rounding(written, driver);
    if (!fault || fault->feature >= features.cells.size()) return;
    throw Error(Message{path, 0,
                        "the format rounds coordinates so that the cell of station " +
                            quoted(features.cells[fault->feature].station, 80) +
                            " is no valid shape: " + fault->reason,
                        "a .gpkg keeps every digit"});
  };
  return write_vector_layer(layer, crs, path, older, warnings);
}

}  // namespace thiessen
