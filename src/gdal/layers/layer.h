#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "gdal/crs/crs.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_record.h"
#include "text/attributes.h"
#include "text/table.h"

namespace thiessen {

/// A layer of a vector file, or a sheet of a spreadsheet, that GDAL reads: its fields as text, and
/// the geometry of each row. Ids and numbers come as written: text stays text (leading zeros,
/// dates), and a double is printed in the shortest digits that read back to it.
class Layer : public Table {
 public:
  /// Opens a layer of a file. `layer` may be empty where the file has one layer; if it has several,
  /// an Error lists them and names `layer_setting`. Throws Error where the file cannot be opened by
  /// one of the drivers of drivers.h, or is not whole (see wholeness.h). What GDAL warns of is
  /// added to `warnings`, if given, when the last row has been read.
  Layer(std::string file, const std::string& layer, const std::string& layer_setting,
        Warnings* warnings = nullptr);
  ~Layer() override;

  const std::string& file() const override;
  const std::vector<std::string>& header() const override;
  /// Reads the next row. At the end the number of rows is held against the number that the file
  /// declares. Throws Error where they differ, and where GDAL reports any error.
  bool next(Row& row) override;
  /// Opens the layer once more; null where that might cost as much as reading all of it (GeoJSON,
  /// KML), or ask a database again.
  std::unique_ptr<Table> first_rows() const override;

  /// The types of the fields, in the order of the header.
  const std::vector<FieldType>& types() const;
  bool has_geometry() const;
  /// The geometry of the row that was read last.
  const GeometryRecord& geometry() const;
  /// The CRS that the file names; empty where it names none. Throws Error where it is not one of
  /// the Earth.
  std::optional<Crs> crs() const;
  /// Whether the file is GeoJSON without a `crs` member that can be used: it is then in WGS 84 by
  /// RFC 7946, and crs() is empty.
  bool crs_implied() const;
  /// Whether the file is GeoJSON, whose features are named by their path in messages.
  bool is_geojson() const;
  /// What is odd about the file: a `crs` link that was not followed, a .dbf that is not there.
  const std::vector<std::string>& oddities() const;

  struct Opened;

 private:
  void hear(const GdalErrors& errors);
  void finish();

  std::unique_ptr<Opened> opened_;
};

}  // namespace thiessen
