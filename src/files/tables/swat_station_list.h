#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "readings/published/swat_files.h"
#include "text/table.h"

namespace thiessen {

/// The gauges of rain of SWAT or SWAT+, as a table: id, longitude, latitude, elevation.
class SwatStationList : public Table {
 public:
  /// Requires a file that is one of SWAT's, and what it is. Throws Error, see swat_gauges.
  SwatStationList(std::string file, SwatFile kind);

  const std::string& file() const override { return file_; }
  const std::vector<std::string>& header() const override { return header_; }
  std::size_t header_line() const override { return 1; }
  bool next(Row& row) override;

 private:
  std::string file_;
  std::vector<std::string> header_ = {"id", "longitude", "latitude", "elevation"};
  std::vector<SwatGauge> gauges_;
  std::size_t next_ = 0;
};

/// What a file on the disk is of SWAT's.
SwatFile swat_file_called(const std::string& file);

}  // namespace thiessen
