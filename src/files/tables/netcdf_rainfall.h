#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/tables/netcdf_stations.h"
#include "files/tables/netcdf_times.h"
#include "text/table.h"

namespace thiessen {

/// The rain of a NetCDF of stations as a table: station, time, and the variable's name.
/// The variable is the one that is named, else one whose standard name or name
/// is rain's, else the only one of all stations and times. Series may stand in
/// one or two dimensions of time, or as ragged arrays, contiguous or indexed.
/// Values outside the valid range that the file gives are missing, which is told at the end.
/// Memory: a block of times.
class NetcdfRainfall : public Table {
 public:
  /// Throws Error where the file is damaged, there is no such variable, or as NetcdfTimes does.
  /// `warnings` must outlive this object and those that `again` opens.
  NetcdfRainfall(std::string file, std::string variable, Warnings& warnings);

  const std::string& file() const override { return file_; }
  const std::vector<std::string>& header() const override { return header_; }
  bool numbers_rows() const override { return true; }
  /// Words name the variable, and the step and the station or the observation, from 1.
  RowPlace place(std::size_t number) const override;
  bool next(Row& row) override;
  std::unique_ptr<Table> again() const override;

  /// The variable's unit, as it is written; empty where none is.
  const std::string& units() const { return units_; }
  const NetcdfTimes& times() const { return *times_; }

 private:
  /// How the series stand in the variable.
  enum class Layout { one_time, time_of_station, contiguous, indexed };
  struct Entry {
    std::size_t station;
    double time;
    double value;
    std::size_t number;  ///< of the value in its variable, from 1
  };

  /// Between which values are valid, both included.
  struct ValidRange {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool is_of_amounts = false;  ///< and not of numbers as they are stored
    std::string attribute = {};  ///< which says so
  };

  NetcdfRainfall(std::string file, std::string variable, Warnings& warnings,
                 std::shared_ptr<bool> has_told);
  void find_layout();
  void find_valid_range();
  bool is_there(double value) const;
  bool is_outside(double value) const;
  void note_outside(const Entry& entry);
  void tell_outside();
  bool load_block();
  bool load_times();
  bool load_station();
  bool load_observations();
  std::vector<double> part_of(int variable, std::size_t begin, std::size_t count) const;

  std::string file_;
  std::string variable_;
  Warnings& warnings_;
  std::shared_ptr<bool> has_told_;  ///< of values outside the valid range, this table or another
  NetcdfStations stations_;
  std::optional<NetcdfTimes> times_;
  std::vector<std::string> header_;
  std::string units_;
  int rain_ = -1;
  Layout layout_ = Layout::one_time;
  std::size_t time_count_ = 0;
  std::vector<std::size_t> row_sizes_;
  int index_ = -1;  ///< the variable of the station of each observation
  bool time_first_ = false;
  std::optional<double> fill_, missing_;
  double scale_ = 1;
  double offset_ = 0;
  nc_type rain_type_ = NC_NAT;
  ValidRange valid_;
  std::size_t outside_ = 0;  ///< values
  std::string first_outside_;

  std::size_t done_ = 0;    ///< times, stations or observations
  std::size_t passed_ = 0;  ///< observations of the stations before
  std::vector<Entry> block_;
  std::size_t next_ = 0;
  std::string time_, value_;
};

}  // namespace thiessen
