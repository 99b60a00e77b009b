#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "files/source.h"
#include "gdal/attribute_filter.h"
#include "gdal/crs.h"
#include "gdal/geometry_record.h"
#include "gdal/layer.h"
#include "text/attributes.h"
#include "text/table.h"

namespace thiessen {

/// The features of a CSV or of a layer, one at a time, alike for both: their fields, their geometry
/// where there is one, and whether the source's filter keeps them.
class Features {
 public:
  /// Opens the source. `longest_field`: bytes, of a CSV's field. Throws Error.
  Features(const Source& source, std::size_t longest_field);
  ~Features();

  const std::string& file() const { return table_->file(); }
  const std::vector<std::string>& header() const { return table_->header(); }
  /// Features are named by the line on which they begin, and not by a number.
  bool has_lines() const { return table_->header_line() > 0; }
  std::size_t header_line() const { return table_->header_line(); }
  bool has_geometry() const;
  DecimalMark decimal_mark() const { return mark_; }
  /// Fields' types, as the file states them; all text for a CSV.
  FieldType type(std::size_t field) const;

  /// Reads the next feature. Rows that cannot be read go to `complaints`, each with its place, once
  /// the last row has been read.
  bool next(Complaints& complaints);
  const Row& row() const { return row_; }
  bool kept() const { return kept_; }
  /// Throws Error where a WKT text cannot be read.
  GeometryRecord geometry() const;

  /// What is wrong with the feature last read.
  Message message(Wording text, Wording hint = {}) const;
  /// `features[3].geometry` in GeoJSON, else `feature 4`; empty in a CSV, whose line says it.
  std::string place() const;

  /// What the source's CRS option says, or the file; for the file alone, by RFC 7946, `implied` is
  /// set. Throws Error where option and file contradict each other.
  struct Named {
    std::optional<Crs> crs;
    bool by_option = false;
    bool implied = false;
  };
  Named crs() const;
  void warn_of_oddities(Warnings& warnings) const;

 private:
  void load_rows();
  bool next_loaded();

  Source source_;
  std::unique_ptr<Table> table_;
  const Layer* layer_ = nullptr;    ///< the table, where it is one
  std::optional<std::size_t> wkt_;  ///< the column of a CSV's geometries
  DecimalMark mark_ = DecimalMark::point;
  std::unique_ptr<AttributeFilter> filter_;
  Row row_;
  bool kept_ = true;
  // A CSV states no types, so that a filter has to see all rows before the first can be judged.
  struct Loaded;
  std::unique_ptr<Loaded> loaded_;
};

}  // namespace thiessen
