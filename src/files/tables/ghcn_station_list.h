#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/error.h"
#include "text/table.h"
#include "text/text_lines.h"

namespace thiessen {

/// Whether a file is a list of stations as GHCN-Daily has it (ghcnd-stations.txt), by its first
/// line. A pipe is none, for it could not be read again.
bool is_ghcn_station_list(const std::string& file);

/// GHCN-Daily's list of stations, as a table: id, latitude, longitude, elevation (empty where it is
/// not known), state, name, gsn_flag, hcn_crn_flag and wmo_id. Columns are those of NOAA's readme.
/// Throws Error, with all lines that are no station's, at the end.
class GhcnStationList : public Table {
 public:
  explicit GhcnStationList(const std::string& file);

  const std::string& file() const override { return file_; }
  const std::vector<std::string>& header() const override { return header_; }
  std::size_t header_line() const override { return first_line; }
  bool next(Row& row) override;

 private:
  static constexpr std::size_t first_line = 1;  // there is no header, but lines have numbers

  std::string file_;
  std::vector<std::string> header_;
  TextLines lines_;
  std::string line_;
  Complaints complaints_;
};

}  // namespace thiessen
