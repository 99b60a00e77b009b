#pragma once

#include <gtest/gtest.h>
#include <netcdf.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace thiessen {

/// A NetCDF file as the library reads it.
class NetcdfReading {
 public:
  explicit NetcdfReading(const std::string& path) { nc_open(path.c_str(), NC_NOWRITE, &file_); }
  ~NetcdfReading() { nc_close(file_); }
  NetcdfReading(const NetcdfReading&) = delete;
  NetcdfReading& operator=(const NetcdfReading&) = delete;

  std::vector<double> numbers(const char* name, std::size_t count) const {
    std::vector<double> values(count);
    EXPECT_EQ(nc_get_var_double(file_, variable(name), values.data()), NC_NOERR) << name;
    return values;
  }
  std::vector<std::string> texts(const char* name, std::size_t count) const {
    std::vector<char*> values(count);
    EXPECT_EQ(nc_get_var_string(file_, variable(name), values.data()), NC_NOERR) << name;
    std::vector<std::string> texts(values.begin(), values.end());
    nc_free_string(count, values.data());
    return texts;
  }
  std::string text(const char* name, const char* attribute) const {
    std::size_t length = 0;
    if (nc_inq_attlen(file_, variable(name), attribute, &length) != NC_NOERR) return "none";
    std::string text(length, '\0');
    nc_get_att_text(file_, variable(name), attribute, text.data());
    return text;
  }
  bool has(const char* name) const {
    int id = -1;
    return nc_inq_varid(file_, name, &id) == NC_NOERR;
  }
  std::string dimensions(const char* name) const {
    std::array<int, 4> ids{};
    int count = 0;
    nc_inq_varndims(file_, variable(name), &count);
    nc_inq_vardimid(file_, variable(name), ids.data());
    std::string names;
    for (int i = 0; i < count; ++i) {
      std::array<char, NC_MAX_NAME + 1> one{};
      nc_inq_dimname(file_, ids.at(static_cast<std::size_t>(i)), one.data());
      names += std::string(i == 0 ? "" : " ") + one.data();
    }
    return names;
  }

 private:
  int variable(const char* name) const {
    int id = NC_GLOBAL;
    if (*name != '\0') {
      EXPECT_EQ(nc_inq_varid(file_, name, &id), NC_NOERR) << name;
    }
    return id;
  }

  int file_ = -1;
};

}  // namespace thiessen
