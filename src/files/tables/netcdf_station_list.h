#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "files/tables/netcdf_stations.h"
#include "text/table.h"

namespace thiessen {

/// The stations of a NetCDF of stations as a table: id, longitude, latitude. The id is
/// the variable whose cf_role is timeseries_id; without one, stations are
/// numbered from 1.
class NetcdfStationList : public Table {
 public:
  /// Throws Error where the file is damaged, or says neither longitude nor
  /// latitude.
  explicit NetcdfStationList(std::string file);

  const std::string& file() const override { return file_; }
  const std::vector<std::string>& header() const override { return header_; }
  std::size_t header_line() const override { return 1; }
  bool next(Row& row) override;

 private:
  std::string file_;
  std::vector<std::string> header_ = {"id", "longitude", "latitude"};
  NetcdfStations stations_;
  std::vector<std::string> longitudes_, latitudes_;
  std::size_t next_ = 0;
};

}  // namespace thiessen
