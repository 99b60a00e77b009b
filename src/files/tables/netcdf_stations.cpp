#include "files/tables/netcdf_stations.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "base/utf8.h"
#include "gdal/layers/netcdf_length.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

bool has_signature(const std::string& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return false;
  std::array<char, 8> bytes = {};
  std::ifstream(file, std::ios::binary).read(bytes.data(), std::ssize(bytes));
  const std::string_view begin(bytes.data(), bytes.size());
  return begin.starts_with("CDF") || begin.starts_with("\x89HDF\r\n\x1a\n");
}

}  // namespace

bool is_netcdf_of_stations(const std::string& file) {
  if (!has_signature(file)) return false;
  require_whole_netcdf(file);  // else whoever reads it would not know that it is a NetCDF it reads
  try {
    const NetcdfStations stations(file);
    return equal_ignoring_case(stations.attribute(NC_GLOBAL, "featureType"), "timeSeries");
  } catch (const Error&) {
    return false;  // whoever reads it says what is wrong
  }
}

NetcdfStations::NetcdfStations(const std::string& file) : name_(file) {
  require_whole_netcdf(file);
  check(nc_open(file.c_str(), NC_NOWRITE, &file_));
  int count = 0;
  check(nc_inq_nvars(file_, &count));
  for (int i = 0; i < count; ++i) variables_.push_back(variable(i));
}

NetcdfStations::~NetcdfStations() {
  if (file_ >= 0) nc_close(file_);
}

void NetcdfStations::find() {
  longitude_ = called("longitude", known::eastings);
  latitude_ = called("latitude", known::northings);
  if (longitude_ == nullptr || latitude_ == nullptr)
    fail("its stations have no longitude or no latitude");
  if (longitude_->dimensions.size() > 1 || longitude_->dimensions != latitude_->dimensions)
    fail("longitude and latitude are not those of stations");
  station_count_ = longitude_->dimensions.empty() ? 1 : length_of(longitude_->dimensions.front());
  for (const Variable& one : variables_) {
    if (attribute(one.number, "cf_role") == "timeseries_id") id_ = &one;
    const bool is_time = attribute(one.number, "standard_name") == "time" || one.name == "time";
    if (is_time && attribute(one.number, "units").find(" since ") != std::string::npos)
      time_ = &one;
  }
  read_ids();
}

void NetcdfStations::check(int status) const {
  if (status != NC_NOERR) fail(std::string("cannot be read: ") + nc_strerror(status));
}

void NetcdfStations::fail(std::string text, Wording hint) const {
  throw Error(Message{name_, 0, std::move(text), std::move(hint)});
}

std::string NetcdfStations::attribute(int variable, const char* name) const {
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(file_, variable, name, &type, &length) != NC_NOERR) return {};
  if (type == NC_STRING && length == 1) {
    char* text = nullptr;
    check(nc_get_att_string(file_, variable, name, &text));
    std::string copy = text == nullptr ? "" : text;
    nc_free_string(1, &text);
    return copy;
  }
  if (type != NC_CHAR) return {};
  std::string text(length, '\0');
  check(nc_get_att_text(file_, variable, name, text.data()));
  return text.substr(0, text.find('\0'));
}

std::optional<double> NetcdfStations::number(int variable, const char* name) const {
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(file_, variable, name, &type, &length) != NC_NOERR || length != 1) return {};
  double value = 0;
  if (nc_get_att_double(file_, variable, name, &value) != NC_NOERR) return {};
  return value;
}

std::vector<double> NetcdfStations::numbers(int variable, const char* name) const {
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(file_, variable, name, &type, &length) != NC_NOERR) return {};
  std::vector<double> values(length);
  if (nc_get_att_double(file_, variable, name, values.data()) != NC_NOERR) return {};
  return values;
}

nc_type NetcdfStations::type_of(int variable, const char* name) const {
  nc_type type = NC_NAT;
  if (nc_inq_atttype(file_, variable, name, &type) != NC_NOERR) return NC_NAT;
  return type;
}

std::size_t NetcdfStations::length_of(int dimension) const {
  std::size_t length = 0;
  check(nc_inq_dimlen(file_, dimension, &length));
  return length;
}

std::string NetcdfStations::name_of_dimension(int dimension) const {
  std::array<char, NC_MAX_NAME + 1> name = {};
  check(nc_inq_dimname(file_, dimension, name.data()));
  return name.data();
}

std::vector<double> NetcdfStations::all_of(const Variable& variable) const {
  std::size_t count = 1;
  for (const int dimension : variable.dimensions) count *= length_of(dimension);
  std::vector<double> values(count);
  check(nc_get_var_double(file_, variable.number, values.data()));
  return values;
}

NetcdfStations::Variable NetcdfStations::variable(int number) const {
  std::array<char, NC_MAX_NAME + 1> name = {};
  std::array<int, NC_MAX_VAR_DIMS> dimensions = {};
  Variable made;
  int count = 0;
  check(nc_inq_var(file_, number, name.data(), &made.type, &count, dimensions.data(), nullptr));
  made.number = number;
  made.name = name.data();
  made.dimensions.assign(dimensions.begin(), dimensions.begin() + count);
  return made;
}

const NetcdfStations::Variable* NetcdfStations::called(
    const char* standard_name, std::span<const std::string_view> names) const {
  for (const Variable& one : variables_) {
    if (attribute(one.number, "standard_name") == standard_name) return &one;
  }
  for (const Variable& one : variables_) {
    if (std::ranges::any_of(names,
                            [&](std::string_view name) { return same_name(one.name, name); }))
      return &one;
  }
  return nullptr;
}

void NetcdfStations::read_ids() {
  if (id_ == nullptr) {
    for (std::size_t i = 0; i < station_count_; ++i) ids_.push_back(std::to_string(i + 1));
  } else if (id_->type == NC_STRING) {
    std::vector<char*> texts(station_count_, nullptr);
    require_one_a_station(id_->dimensions.size());
    check(nc_get_var_string(file_, id_->number, texts.data()));
    for (const char* text : texts) ids_.emplace_back(text == nullptr ? "" : text);
    nc_free_string(texts.size(), texts.data());
  } else if (id_->type == NC_CHAR) {
    read_ids_of_letters();
  } else {
    require_one_a_station(id_->dimensions.size());
    for (const double one : all_of(*id_)) ids_.push_back(shortest_text(one));
  }
}

void NetcdfStations::require_one_a_station(std::size_t dimensions) const {
  const bool fits =
      dimension() < 0 ? dimensions == 0 : dimensions == 1 && id_->dimensions.front() == dimension();
  if (!fits) fail("the variable " + quoted(id_->name, 60) + " does not name the stations");
}

void NetcdfStations::read_ids_of_letters() {
  const std::size_t wanted = dimension() < 0 ? 1 : 2;
  const bool fits =
      id_->dimensions.size() == wanted && (wanted == 1 || id_->dimensions.front() == dimension());
  if (!fits) fail("the variable " + quoted(id_->name, 60) + " does not name the stations");
  const std::size_t width = length_of(id_->dimensions.back());
  std::string letters(station_count_ * width, '\0');
  check(nc_get_var_text(file_, id_->number, letters.data()));
  for (std::size_t i = 0; i < station_count_; ++i) {
    const std::string_view text = std::string_view(letters).substr(i * width, width);
    ids_.emplace_back(trimmed(text.substr(0, text.find('\0'))));
  }
}

}  // namespace thiessen
