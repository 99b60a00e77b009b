#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "files/tables/source.h"
#include "gdal/crs/crs.h"
#include "gdal/layers/attribute_filter.h"
#include "gdal/layers/geometry_record.h"
#include "gdal/layers/layer.h"
#include "text/attributes.h"
#include "text/table.h"

namespace thiessen {

/// Reads the features of a CSV or of a layer one at a time, alike for both: their fields, their
/// geometry where there is one, and whether the filter of the source keeps them.
class Features {
 public:
  /// Opens the source. `longest_field` is the limit of a CSV's field in bytes. What GDAL warns of
  /// goes to `warnings`, which must live until the last feature is read. Throws Error.
  Features(const Source& source, std::size_t longest_field, Warnings& warnings);
  ~Features();

  const std::string& file() const { return table_->file(); }
  const std::vector<std::string>& header() const { return table_->header(); }
  /// Whether messages name a feature by the line on which it begins, and not by its number.
  bool has_lines() const { return table_->header_line() > 0; }
  std::size_t header_line() const { return table_->header_line(); }
  bool has_geometry() const;
  /// Whether geometries are in a column whose name, such as geom, may mean something else.
  bool may_not_be_geometries() const;
  /// Whether a field is the one of a CSV that holds the geometries.
  bool is_geometry(std::size_t field) const { return wkt_ == field; }
  DecimalMark decimal_mark() const { return mark_; }
  /// The type of a field as the file states it; text for every field of a CSV.
  FieldType type(std::size_t field) const;

  /// Reads the next feature, and returns false at the end. Rows that cannot be read go to
  /// `complaints`, each with its place, once the last row has been read.
  bool next(Complaints& complaints);
  const Row& row() const { return row_; }
  bool kept() const { return kept_; }
  /// The geometry of the feature last read. Throws Error where the text of one cannot be read, or
  /// names another CRS (SRID) than one before it.
  GeometryRecord geometry();

  /// A message about the feature last read, with its place in the file.
  Message message(Wording text, Wording hint = {}) const;
  /// Words the place of the feature last read: `features[3].geometry` in GeoJSON, else `feature 4`;
  /// empty for a CSV, where the line says it.
  std::string place() const;

  /// The CRS that the option of the source names, else that of the file, which texts of geometries
  /// may name (EWKT): ask when they have been read. `implied` is set where the
  /// file says nothing and RFC 7946 implies WGS 84. Throws Error where option and file contradict
  /// each other.
  struct Named {
    std::optional<Crs> crs;
    bool by_option = false;
    bool implied = false;
  };
  Named crs() const;
  /// The CRS that the option of the source names, for coordinates in columns: what the file says of
  /// its geometries says nothing of these.
  std::optional<Crs> crs_of_columns() const;
  void warn_of_oddities(Warnings& warnings) const;

 private:
  void load_rows();
  bool next_loaded();

  Source source_;
  std::unique_ptr<Table> table_;
  const Layer* layer_ = nullptr;    ///< not null: the table is this layer
  std::optional<std::size_t> wkt_;  ///< the column of a CSV's geometries
  int srid_ = 0;                    ///< that geometries of a CSV name; 0: none does
  DecimalMark mark_ = DecimalMark::point;
  std::unique_ptr<AttributeFilter> filter_;
  Row row_;
  bool kept_ = true;
  // The rows of a CSV, for a filter: a CSV states no types, so that a filter has to see all rows
  // before the first can be judged.
  struct Loaded;
  std::unique_ptr<Loaded> loaded_;
};

}  // namespace thiessen
