#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "text/table.h"

namespace thiessen {

/// A table over another one, of which it changes or leaves out rows, names or units. What is said
/// of the file is said by the other table. Whether a row waits, and what was seen of a first row,
/// is each one's own to say, for one row here may be several there.
class TableOver : public Table {
 public:
  const std::string& file() const override { return table_->file(); }
  const std::vector<std::string>& header() const override { return table_->header(); }
  DecimalMark decimal_mark() const override { return table_->decimal_mark(); }
  std::string unit(std::size_t field) const override { return table_->unit(field); }
  std::vector<std::string> lines_above() const override { return table_->lines_above(); }
  std::size_t header_line() const override { return table_->header_line(); }
  bool numbers_rows() const override { return table_->numbers_rows(); }
  RowPlace place(std::size_t number) const override { return table_->place(number); }
  bool next(Row& row) override { return table_->next(row); }
  double share_read() const override { return table_->share_read(); }
  std::unique_ptr<Table> again() const override { return over_if_any(table_->again()); }
  std::unique_ptr<Table> first_rows() const override { return over_if_any(table_->first_rows()); }

 protected:
  explicit TableOver(std::unique_ptr<Table> table) : table_(std::move(table)) {}
  /// The same over another table, which is never null.
  virtual std::unique_ptr<Table> over(std::unique_ptr<Table> table) const = 0;

  std::unique_ptr<Table> table_;

 private:
  std::unique_ptr<Table> over_if_any(std::unique_ptr<Table> table) const {
    return table ? over(std::move(table)) : nullptr;
  }
};

}  // namespace thiessen
