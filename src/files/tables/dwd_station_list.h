#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "text/table.h"
#include "text/text_lines.h"

namespace thiessen {

/// Whether a file is a list of stations as DWD has it (RR_Tageswerte_Beschreibung_Stationen.txt),
/// by its header. A pipe is none, for it could not be read again.
bool is_dwd_station_list(const std::string& file);

/// DWD's list of stations, as a table: Stations_id, von_datum, bis_datum, Stationshoehe, geoBreite,
/// geoLaenge, Stationsname, Bundesland. Blanks part the first six, and two or more of them the
/// names. Lines that are not UTF-8 are taken for Latin-1. Throws Error, with all lines that are no
/// station's, at the end.
class DwdStationList : public Table {
 public:
  explicit DwdStationList(const std::string& file);

  const std::string& file() const override { return file_; }
  const std::vector<std::string>& header() const override { return header_; }
  std::size_t header_line() const override { return 1; }
  bool next(Row& row) override;

 private:
  bool read(std::string_view line, Row& row) const;

  std::string file_;
  std::vector<std::string> header_;
  TextLines lines_;
  std::string line_;
  Complaints complaints_;
};

}  // namespace thiessen
