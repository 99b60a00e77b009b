#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "readings/published/published_format.h"
#include "text/table.h"
#include "text/text_lines.h"

namespace thiessen {

/// Opens a file at its beginning; called once for each look through it.
using OpenInput = std::function<InputFile()>;

/// How the readings of USGS's RDB are read, once UsgsRdb has made a table of them.
const PublishedFormat& usgs_rdb_format();

/// Whether a text begins as a file of values in USGS's RDB that has a column of precipitation:
/// remarks, and then a header of agency_cd, site_no and datetime. Each site has its own.
bool is_usgs_rdb(std::string_view beginning);

/// Whether a file of USGS's RDB has a site with a column of precipitation. Reads it up to there.
bool has_usgs_rain(InputFile file);

/// Whether a column of USGS's RDB holds precipitation: 68487_00045, or of days 68487_00045_00006.
bool is_usgs_rain(std::string_view column);

/// The precipitation (00045, in inches) in a file of USGS's RDB, as a table of site_no, datetime
/// and precipitation. Each site begins with remarks, a header of its own and a row of formats; its
/// first column of precipitation is taken, of daily values the first of sums, and where there are
/// several a notice says which. Times in a zone (tz_cd) are brought to the standard time of the
/// first row's zone, so that they do not jump in spring and autumn; that is told at the end.
///
/// Throws Error at the end with all rows that have too few fields, or a time or a zone that is
/// none, where sites begin without a header, and where daily values are no sums.
class UsgsRdb : public Table {
 public:
  /// `wanted`: the one column that is taken, of whatever statistic; empty: as above. `warnings`
  /// must outlive this object and those that `again` makes of it.
  UsgsRdb(std::string file, OpenInput open, std::string wanted, Warnings& warnings);

  const std::string& file() const override { return file_; }
  const std::vector<std::string>& header() const override { return header_; }
  std::size_t header_line() const override { return header_line_; }
  bool next(Row& row) override;
  double share_read() const override { return lines_.share_read(); }
  std::unique_ptr<Table> again() const override;
  /// The zone whose standard time all times are in; empty where the file names none.
  const std::string& zone() const { return zone_; }

 private:
  struct Columns {
    std::size_t count = 0;
    std::size_t site = 0;
    std::size_t time = 0;
    std::optional<std::size_t> zone;
    std::optional<std::size_t> rain;
  };

  /// What all readers of the file have together.
  struct Told {
    bool columns = false;
    bool zone = false;
  };

  void read_header(const std::vector<std::string_view>& names);
  std::optional<std::size_t> rain_among(const std::vector<std::string_view>& names);
  void tell_zone();
  bool read_row(const std::vector<std::string_view>& fields, Row& row);
  bool read_time(const std::vector<std::string_view>& fields);
  void complain(std::string text);

  std::string file_;
  OpenInput open_;
  std::string wanted_;
  Warnings& warnings_;
  std::shared_ptr<Told> told_ = std::make_shared<Told>();
  TextLines lines_;
  std::vector<std::string> header_ = {"site_no", "datetime", "precipitation"};
  std::size_t header_line_ = 0;
  Columns columns_;
  std::string zone_;
  int ahead_ = 0;           ///< of UTC, in minutes, of the standard time of that zone
  std::string other_zone_;  ///< the first from which a time was brought there
  std::string line_;
  std::string time_;
  Complaints complaints_;
};

}  // namespace thiessen
