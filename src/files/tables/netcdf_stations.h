#pragma once

#include <netcdf.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/wording.h"

namespace thiessen {

/// Whether a file is a NetCDF of stations, whose featureType is timeSeries: the
/// discrete sampling geometries of CF (chapter 9 of its conventions).
bool is_netcdf_of_stations(const std::string& file);

/// What is said of a file of stations that is one.
inline constexpr const char* read_as_netcdf = "read as a NetCDF of stations";

/// A NetCDF of stations that is open: its variables by what they are in CF. All
/// throw Error where the file is damaged.
class NetcdfStations {
 public:
  struct Variable {
    int number = -1;
    std::string name;
    nc_type type = NC_NAT;
    std::vector<int> dimensions;
  };

  explicit NetcdfStations(const std::string& file);
  ~NetcdfStations();
  NetcdfStations(const NetcdfStations&) = delete;
  NetcdfStations& operator=(const NetcdfStations&) = delete;

  /// Finds what the file has of stations: where they are, what they are called,
  /// and the times. Throws Error where it says neither longitude nor latitude.
  void find();

  int file() const { return file_; }
  const std::vector<Variable>& variables() const { return variables_; }
  const Variable* longitude() const { return longitude_; }
  const Variable* latitude() const { return latitude_; }
  /// Null where the file has no times.
  const Variable* time() const { return time_; }
  std::size_t count() const { return station_count_; }
  const std::vector<std::string>& ids() const { return ids_; }
  /// The dimension of the stations; -1 where there is one station without any.
  int dimension() const {
    return longitude_->dimensions.empty() ? -1 : longitude_->dimensions.front();
  }

  /// An attribute of a variable that is a text; empty where it has none.
  std::string attribute(int variable, const char* name) const;
  std::optional<double> number(int variable, const char* name) const;
  /// An attribute that is numbers; none where there is none such.
  std::vector<double> numbers(int variable, const char* name) const;
  /// The type of an attribute; NC_NAT where there is none.
  nc_type type_of(int variable, const char* name) const;
  std::size_t length_of(int dimension) const;
  std::string name_of_dimension(int dimension) const;
  std::vector<double> all_of(const Variable& variable) const;

  /// Throws Error where a function of the library has failed.
  void check(int status) const;
  [[noreturn]] void fail(std::string text, Wording hint = {}) const;

 private:
  Variable variable(int number) const;
  const Variable* called(const char* standard_name, std::span<const std::string_view> names) const;
  void read_ids();
  void read_ids_of_letters();
  void require_one_a_station(std::size_t dimensions) const;

  std::string name_;
  int file_ = -1;
  std::vector<Variable> variables_;
  const Variable* longitude_ = nullptr;
  const Variable* latitude_ = nullptr;
  const Variable* time_ = nullptr;
  const Variable* id_ = nullptr;
  std::size_t station_count_ = 0;
  std::vector<std::string> ids_;
};

}  // namespace thiessen
