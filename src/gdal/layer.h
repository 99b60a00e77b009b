#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gdal/crs.h"
#include "gdal/geometry_record.h"
#include "text/attributes.h"
#include "text/table.h"

namespace thiessen {

/// A layer of a vector file, or a sheet of a spreadsheet, that GDAL reads: its fields as text, and
/// the geometry of each row. Ids and numbers come as written: text stays text (leading zeros,
/// dates), and a double prints in the shortest digits that read back to it.
class Layer : public Table {
 public:
  /// `layer` may be empty where the file has one layer; several and none named is an Error that
  /// lists them and names `layer_setting`. Throws Error where the file cannot be opened by one of
  /// the drivers of drivers.h, or is not whole.
  Layer(std::string file, const std::string& layer, const std::string& layer_setting);
  ~Layer() override;

  const std::string& file() const override;
  const std::vector<std::string>& header() const override;
  bool next(Row& row) override;

  /// In the order of the header.
  const std::vector<FieldType>& types() const;
  bool has_geometry() const;
  /// Of the row last read.
  const GeometryRecord& geometry() const;
  /// The CRS that the file names. Throws Error where it is not one of the Earth.
  std::optional<Crs> crs() const;
  /// GeoJSON without a `crs` member: WGS 84 by RFC 7946, and crs() is nothing.
  bool crs_implied() const;
  /// GeoJSON, whose features are named by their path.
  bool is_geojson() const;
  /// What was odd about the file: a `crs` link that was not followed.
  const std::vector<std::string>& oddities() const;

  struct Opened;

 private:
  std::unique_ptr<Opened> opened_;
};

}  // namespace thiessen
