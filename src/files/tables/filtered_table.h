#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "gdal/layers/attribute_filter.h"
#include "text/attributes.h"
#include "text/table.h"

namespace thiessen {

/// The rows of a table that an OGR attribute filter keeps. They are judged one by one, so that
/// memory does not grow with the table.
///
/// A table of texts states no types. A field that holds numbers alone in the first 64 kB is one of
/// numbers, and any other is text. Where the filter asks a field of numbers and a later row holds
/// something else in it, that is an error, for a comparison would be wrong in silence.
class FilteredTable : public Table {
 public:
  /// What is to be kept, and what the filter is called in messages.
  struct Filter {
    std::string where;
    std::string its_setting;
  };

  /// `fields` are those of the table with their types. A warning is given where no row is kept;
  /// `warnings` must outlive this object, and is null where nothing is to be said. Throws Error as
  /// AttributeFilter does.
  FilteredTable(std::unique_ptr<Table> table, Filter filter, std::vector<FieldName> fields,
                Warnings* warnings);

  const std::string& file() const override { return table_->file(); }
  const std::vector<std::string>& header() const override { return table_->header(); }
  DecimalMark decimal_mark() const override { return table_->decimal_mark(); }
  std::string unit(std::size_t field) const override { return table_->unit(field); }
  std::vector<std::string> lines_above() const override { return table_->lines_above(); }
  std::size_t header_line() const override { return table_->header_line(); }
  bool next(Row& row) override;
  double share_read() const override { return table_->share_read(); }
  bool numbers_rows() const override { return table_->numbers_rows(); }
  RowPlace place(std::size_t number) const override { return table_->place(number); }
  std::unique_ptr<Table> again() const override { return filtered(table_->again()); }
  std::unique_ptr<Table> first_rows() const override { return filtered(table_->first_rows()); }

 private:
  std::unique_ptr<Table> filtered(std::unique_ptr<Table> table) const;
  bool next_row(Row& row);
  bool has_types(const Row& row);
  void conclude();

  std::unique_ptr<Table> table_;
  Filter filter_;
  std::vector<FieldName> fields_;
  AttributeFilter keeps_;
  std::vector<std::size_t> numbers_;  ///< the fields of numbers that the filter asks
  Warnings* warnings_;                ///< null: nothing is said
  Complaints complaints_;
  std::size_t read_ = 0;
  std::size_t kept_ = 0;
};

/// The rows of a table that the filter keeps. `types` are those of the fields where the table
/// states them, and empty where they are to be found out. Throws Error as FilteredTable does, and
/// where a table of texts can be read only once.
std::unique_ptr<Table> keep_rows(std::unique_ptr<Table> table, FilteredTable::Filter filter,
                                 std::vector<FieldType> types, Warnings& warnings);

}  // namespace thiessen
