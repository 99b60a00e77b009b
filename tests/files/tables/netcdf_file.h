#pragma once

#include <gtest/gtest.h>
#include <netcdf.h>

#include <map>
#include <string>
#include <vector>

namespace thiessen {

/// A NetCDF of the stations `a` and `b`, as a test has it: hourly times, and their rain in mm.
struct NetcdfOfStations {
  std::string units = "mm";
  std::string time_units = "hours since 2020-01-01 00:00:00";
  std::vector<double> times = {0, 1, 2};
  std::vector<double> bounds = {};  ///< a pair for each time; none where it is empty
  std::map<std::string, std::string> time_attributes = {};
  std::map<std::string, std::vector<double>> rain_attributes = {};
  nc_type rain_type = NC_DOUBLE;
  std::vector<double> rain = {4, 5, -999, 8, 9, 10};  ///< of `a`, then of `b`

  std::string write(const std::string& path) const {
    int file = 0;
    EXPECT_EQ(nc_create(path.c_str(), NC_CLOBBER, &file), NC_NOERR);
    int station = 0, time = 0, letter = 0, pair = 0;
    nc_def_dim(file, "station", 2, &station);
    nc_def_dim(file, "time", times.size(), &time);
    nc_def_dim(file, "letter", 1, &letter);
    nc_def_dim(file, "pair", 2, &pair);
    const int lon = variable(file, "lon", NC_DOUBLE, {station});
    const int lat = variable(file, "lat", NC_DOUBLE, {station});
    const int id = variable(file, "id", NC_CHAR, {station, letter});
    const int at = variable(file, "time", NC_DOUBLE, {time});
    const int pr = variable(file, "pr", rain_type, {station, time});
    const int around = bounds.empty() ? -1 : variable(file, "time_bnds", NC_DOUBLE, {time, pair});
    put(file, NC_GLOBAL, "featureType", "timeSeries");
    put(file, id, "cf_role", "timeseries_id");
    put(file, at, "units", time_units);
    if (!bounds.empty()) put(file, at, "bounds", "time_bnds");
    for (const auto& [name, text] : time_attributes) put(file, at, name, text);
    put(file, pr, "units", units);
    const double missing = -999;
    nc_put_att_double(file, pr, "missing_value", rain_type, 1, &missing);
    for (const auto& [name, numbers] : rain_attributes)
      nc_put_att_double(file, pr, name.c_str(), NC_DOUBLE, numbers.size(), numbers.data());
    nc_enddef(file);
    const std::vector<double> places = {0, 2};
    nc_put_var_double(file, lon, places.data());
    nc_put_var_double(file, lat, places.data());
    nc_put_var_text(file, id, "ab");
    nc_put_var_double(file, at, times.data());
    nc_put_var_double(file, pr, rain.data());
    if (!bounds.empty()) nc_put_var_double(file, around, bounds.data());
    EXPECT_EQ(nc_close(file), NC_NOERR);
    return path;
  }

 private:
  static int variable(int file, const char* name, nc_type type, const std::vector<int>& of) {
    int number = -1;
    EXPECT_EQ(nc_def_var(file, name, type, static_cast<int>(of.size()), of.data(), &number),
              NC_NOERR);
    return number;
  }
  static void put(int file, int variable, const std::string& name, const std::string& text) {
    nc_put_att_text(file, variable, name.c_str(), text.size(), text.data());
  }
};

}  // namespace thiessen
