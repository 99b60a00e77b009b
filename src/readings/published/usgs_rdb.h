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

/// The precipitation (00045, in inches) in a file of USGS's RDB, as a table of site_no, datetime
/// and precipitation. Each site begins with remarks, a header of its own and a row of formats; the
/// first column of precipitation is taken, of daily values the one of sums. Times in a zone
/// (tz_cd) are brought to the standard time of the first row's zone, so that they do not jump in
/// spring and autumn.
///
/// Throws Error at the end with all rows that have too few fields, or a time or a zone that is
/// none, and where sites begin without a header.
class UsgsRdb : public Table {
 public:
  UsgsRdb(std::string file, OpenInput open);

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

  void read_header(const std::vector<std::string_view>& names);
  bool read_row(const std::vector<std::string_view>& fields, Row& row);
  bool read_time(const std::vector<std::string_view>& fields);
  void complain(std::string text);

  std::string file_;
  OpenInput open_;
  TextLines lines_;
  std::vector<std::string> header_ = {"site_no", "datetime", "precipitation"};
  std::size_t header_line_ = 0;
  Columns columns_;
  std::string zone_;
  int ahead_ = 0;  ///< of UTC, in minutes, of the standard time of that zone
  std::string line_;
  std::string time_;
  Complaints complaints_;
};

}  // namespace thiessen
