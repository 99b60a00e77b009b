#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "base/error.h"
#include "readings/published/published_format.h"
#include "text/table.h"

namespace thiessen {

/// How the readings are read that MonthRows makes of a table.
const PublishedFormat& ana_format();

/// Whether a header is one of ANA's Hidroweb: a row a month, with a column a day (Chuva01 to
/// Chuva31).
bool is_ana_header(const std::vector<std::string>& header);

/// The rain of a table with a row a month and a column a day, as a table of EstacaoCodigo, Data and
/// Chuva with a row a day. Where a month is there raw and checked (NivelConsistencia 1 and 2), the
/// checked one is read. Days that a month lacks are passed over. Throws Error as the table does,
/// and at the end, with their lines, for dates that are none and for rain that is no number or
/// negative.
class MonthRows : public Table {
 public:
  /// Requires a table whose header is one of ANA's. Which months are checked is looked up in the
  /// table read once more, or in `same`, a second reader of it, where it cannot be (a packed one);
  /// where there is neither, months that are there raw and checked are read both.
  explicit MonthRows(std::unique_ptr<Table> table, std::unique_ptr<Table> same = nullptr);

  const std::string& file() const override { return table_->file(); }
  const std::vector<std::string>& header() const override { return header_; }
  DecimalMark decimal_mark() const override { return table_->decimal_mark(); }
  bool numbers_rows() const override { return true; }
  RowPlace place(std::size_t number) const override { return table_->place(number / days_a_line); }
  bool next(Row& row) override;
  double share_read() const override { return table_->share_read(); }
  std::unique_ptr<Table> again() const override;

 private:
  static constexpr std::size_t most_days = 31;
  static constexpr std::size_t days_a_line = 32;  ///< rows that may be numbered in a line

  void find_checked(std::unique_ptr<Table> same);
  bool next_month();
  bool read_month();
  void check_day(std::size_t day);
  std::string key(const Row& row) const;
  bool is_checked(const Row& row) const;

  std::unique_ptr<Table> table_;
  std::vector<std::string> header_ = {"EstacaoCodigo", "Data", "Chuva"};
  std::size_t station_;
  std::size_t date_;
  std::size_t level_;
  std::array<std::size_t, most_days> days_ = {};
  std::unordered_set<std::string> checked_;  ///< months that are there as checked
  Row month_;
  std::string month_text_;  ///< 2020-01-
  std::size_t day_ = 0;     ///< the next one, from 0
  std::size_t day_count_ = 0;
  std::string time_;
  Complaints complaints_;
};

}  // namespace thiessen
