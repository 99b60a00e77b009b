#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "readings/published/published_format.h"
#include "text/table.h"

namespace thiessen {

/// How the readings are read that HourlyOrder makes of a table.
const PublishedFormat& hourly_order_format();

/// Whether a header is one of an order of hourly precipitation (HPCP) of NOAA's Climate Data
/// Online, with flags of measurement: without these nothing tells missing hours from dry ones.
bool is_hourly_order_header(const std::vector<std::string>& header);

/// The rain of such an order as a table of STATION, DATE, HPCP and Quality Flag with a row an hour.
///
/// Hours without rain have no row in the order. Between two rows of a station, which are at most a
/// month apart unless it did not report, they are dry, but in
/// a period whose flags say that it is missing ([ and ]), deleted ({ and }) or one of which only
/// the sum is known (a or a comma, and A): there hours, and the sum, are empty. Of the flags of
/// quality those are kept that mean that a value failed a check or lacks a part of its hour. Throws
/// Error as the table does, and at the end for rows whose time is none, or goes back.
class HourlyOrder : public Table {
 public:
  /// Requires a table whose header is one of such an order.
  explicit HourlyOrder(std::unique_ptr<Table> table);

  const std::string& file() const override { return table_->file(); }
  const std::vector<std::string>& header() const override { return header_; }
  DecimalMark decimal_mark() const override { return table_->decimal_mark(); }
  std::string unit(std::size_t field) const override;
  std::size_t header_line() const override { return table_->header_line(); }
  bool numbers_rows() const override { return true; }
  RowPlace place(std::size_t number) const override;
  bool next(Row& row) override;
  double share_read() const override { return table_->share_read(); }
  std::unique_ptr<Table> again() const override;

 private:
  /// A row of the order.
  struct Hour {
    std::string station;
    std::string time;  ///< as it is written
    std::int64_t hour = 0;
    std::string value;  ///< empty where there is no reading
    std::string quality;
    bool ends_gap = false;  ///< the hours before it are none that are dry
    bool begins_gap = false;
  };
  /// At which number of a row the rows of a line begin.
  struct Begun {
    std::size_t number;
    std::size_t line;
  };

  HourlyOrder(const HourlyOrder& other, std::unique_ptr<Table> table);
  bool read_hour();
  std::optional<Hour> hour_of(const Row& row);
  void give(Row& row, std::string_view time, std::string_view value, std::string_view quality);

  std::unique_ptr<Table> table_;
  std::vector<std::string> header_ = {"STATION", "DATE", "HPCP", "Quality Flag"};
  std::size_t station_;
  std::size_t date_;
  std::size_t value_;
  std::size_t flag_;
  std::optional<std::size_t> quality_;
  std::optional<Hour> read_;  ///< the row of the order that comes after the hours before it
  std::string station_now_;
  std::int64_t next_hour_ = 0;  ///< of the station, that has not come yet
  bool is_gap_ = false;         ///< hours without a row are none that are dry
  std::string time_;
  std::string value_text_;
  std::string quality_text_;
  std::size_t number_ = 1;  ///< of the next row
  std::shared_ptr<std::vector<Begun>> begun_ = std::make_shared<std::vector<Begun>>();
  Row row_;
  Complaints complaints_;
};

}  // namespace thiessen
