#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "gdal/layers/sheet_book.h"
#include "gdal/layers/sheet_rows.h"
#include "text/table.h"

namespace thiessen {

/// A sheet of a .xlsx or a .ods file as a table of texts. GDAL's readers know a time by its cell's
/// form alone, of some forms the date only, and take the first row for the header; here the number
/// in the cell is the time (see time_of_serial).
///
/// The header is the first row that is not empty; where it has no known name, it is the first of
/// the next ones that has a known name of a time or a station and as many cells as the row below
/// it, which is said in a notice, and so is a row of units below it, which is passed over. Rows
/// have the numbers that the sheet gives them.
class SheetTable : public Table {
 public:
  /// What is wanted of a file. `skip` says how many rows stand before the header.
  struct Request {
    std::string file;
    std::string name;   ///< as GDAL is given it
    std::string layer;  ///< empty where the file has one sheet that is not empty
    std::string layer_setting;
    std::optional<std::size_t> skip;
    SheetKind kind = SheetKind::xlsx;
  };

  /// `warnings` are null where nothing is to be said. Throws Error where the file is no whole
  /// spreadsheet, where there is no such sheet, or where there are several and none is named.
  SheetTable(Request request, Warnings* warnings);

  const std::string& file() const override { return request_.file; }
  const std::vector<std::string>& header() const override { return header_; }
  std::size_t header_line() const override { return header_row_; }
  std::string unit(std::size_t field) const override {
    return field < units_.size() ? units_[field] : std::string();
  }
  std::vector<std::string> lines_above() const override { return lines_above_; }
  bool next(Row& row) override;
  std::unique_ptr<Table> again() const override;

 private:
  SheetTable(Request request, std::shared_ptr<const SheetBook> book, std::size_t sheet,
             Warnings* warnings);
  std::size_t chosen_sheet() const;
  void pass_to_header(Warnings* warnings);
  void keep_line_above(const SheetRow& row);
  void pass_units(Warnings* warnings);
  void see_clocks();
  std::string text_of(const SheetCell& cell, std::size_t column) const;

  Request request_;
  std::shared_ptr<const SheetBook> book_;
  std::size_t sheet_;
  std::unique_ptr<SheetRows> rows_;
  std::vector<std::string> header_;
  std::size_t header_row_ = 0;
  std::vector<std::string> lines_above_;
  std::vector<std::string> units_;  ///< by column, as a row below the header says; or none
  std::vector<bool> has_clock_;  ///< by column: whether its times have one, as far as is read ahead
  std::vector<std::string> texts_;
  Complaints complaints_;
};

}  // namespace thiessen
