#include "files/stations_file.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <unordered_map>
#include <utility>

#include "base/number.h"
#include "base/secrets.h"
#include "base/utf8.h"
#include "files/crs_fit.h"
#include "files/features.h"
#include "geometry/shape_points.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_field = std::size_t{1} << 20U;

/// The field whose name is `named` (the setting `x` or `y`), else the first that has one of the
/// usual names.
std::optional<std::size_t> coordinate_field(const Features& features, const std::string& named,
                                            const char* its_setting,
                                            std::span<const std::string_view> names) {
  if (named.empty()) return find_field(features.header(), names);
  return require_field(features.header(), named, setting(its_setting), features.file(),
                       features.header_line());
}

[[noreturn]] void fail_without_coordinates(const Features& features, bool x, bool y) {
  std::string wanted;
  if (!x) wanted = listed(std::span(known::eastings).first(known::eastings_told));
  if (!y)
    wanted +=
        (x ? "" : ", and ") + listed(std::span(known::northings).first(known::northings_told));
  throw Error(
      Message{features.file(), features.header_line(),
              "no field of coordinates: wanted " + wanted + "; found " + listed(features.header()),
              x   ? "name it with " + setting("y")
              : y ? "name it with " + setting("x")
                  : "name them with " + setting("x") + " and " + setting("y")});
}

bool holds_degrees(const std::string& name) {
  return std::any_of(known::degrees.begin(), known::degrees.end(),
                     [&](std::string_view degrees) { return same_name(name, degrees); });
}

/// Reads the stations of one file, a feature at a time.
class StationsReader {
 public:
  StationsReader(const StationsRequest& request, Warnings& warnings)
      : request_(request), warnings_(warnings), features_(request.source, longest_field, warnings) {
    result_.file = features_.file();
    result_.has_lines = features_.has_lines();
    find_fields();
    name_crs();
  }

  StationsFile read() {
    features_.warn_of_oddities(warnings_);
    while (features_.next(complaints_)) {
      if (features_.kept()) {
        add_station();
      } else {
        result_.filtered_ids.emplace(features_.row().fields[id_]);
      }
    }
    complain_of_range(result_, complaints_);
    complaints_.throw_if_any();
    require_some();
    if (heights_) warnings_.add({features_.file(), 0, "heights (Z) are passed over", {}});
    finish_attributes();
    return std::move(result_);
  }

 private:
  void find_fields() {
    const auto& header = features_.header();
    if (header.empty())
      throw Error(Message{features_.file(), 0, "has no field that could be the id", {}});
    id_ = station_id_field(features_, request_);
    if (!request_.label.empty())
      label_ = require_field(header, request_.label, setting("label"), features_.file(),
                             features_.header_line());
    by_geometry_ = features_.has_geometry() && request_.x.empty() && request_.y.empty();
    if (by_geometry_) return;
    const auto x = coordinate_field(features_, request_.x, "x", known::eastings);
    const auto y = coordinate_field(features_, request_.y, "y", known::northings);
    if (!x || !y) fail_without_coordinates(features_, x.has_value(), y.has_value());
    x_ = *x;
    y_ = *y;
  }

  void name_crs() {
    if (by_geometry_) {
      const Features::Named named = features_.crs();
      result_.crs = named.crs;
      if (!named.crs) return;
      result_.crs_origin = named.by_option ? CrsOrigin::option
                           : named.implied ? CrsOrigin::implied
                                           : CrsOrigin::file;
    } else if (const auto wanted = features_.crs_of_columns()) {
      result_.crs = wanted;
      result_.crs_origin = CrsOrigin::option;
    } else if (holds_degrees(features_.header()[x_]) && holds_degrees(features_.header()[y_])) {
      result_.crs = Crs::wgs84();
      result_.crs_origin = CrsOrigin::columns;
    }
  }

  void add_station() {
    const Row& row = features_.row();
    Station station{std::string(row.fields[id_]), {}, row.line};
    bool good = by_geometry_ ? read_geometry(station) : read_columns(station);
    if (station.id.empty()) {
      complain("a station has no id");
      good = false;
    }
    const auto [first, fresh] = lines_.emplace(station.id, row.line);
    if (!fresh && !station.id.empty()) {
      complain("station " + quoted(station.id, 80) + " is already in " +
                   (features_.has_lines() ? "line " : "feature ") + std::to_string(first->second),
               "ids must differ; " + setting("id") + " names another field, " +
                   setting(request_.source.where_setting) + " leaves stations out");
      good = false;
    }
    if (!good) return;
    if (label_ && !row.fields[*label_].empty())
      result_.labels.emplace(station.id, std::string(row.fields[*label_]));
    result_.stations.push_back(std::move(station));
    if (request_.attributes) keep_attributes(row);
  }

  bool read_columns(Station& station) {
    const auto x = read_number(station, x_);
    const auto y = read_number(station, y_);
    // Adding zero turns -0 into 0, so that both are the same place.
    if (x && y) station.position = {*x + 0.0, *y + 0.0};
    return x && y;
  }

  std::optional<double> read_number(const Station& station, std::size_t field) {
    const std::string_view text = trimmed(features_.row().fields[field]);
    const auto number = parse_number(text, features_.decimal_mark());
    if (number) return number.value;
    const std::string what =
        quoted(features_.header()[field], 40) + " of station " + quoted(station.id, 80);
    if (text.empty()) {
      complain(what + " is empty");
    } else if (number.fault == NumberFault::out_of_range) {
      complain(what + " is outside the range of numbers: " + quoted(text, 60));
    } else {
      complain(what + " is no number: " + quoted(text, 60),
               parse_number(text, DecimalMark::comma)
                   ? setting("decimal_comma") + " reads 1,5 as 1.5"
                   : Wording());
    }
    return std::nullopt;
  }

  bool read_geometry(Station& station) {
    try {
      const GeometryRecord geometry = features_.geometry();
      const std::string what = "station " + quoted(station.id, 80);
      if (geometry.type.empty()) return complain(what + " has no geometry", leave_out());
      if (geometry.type != "Point" && geometry.type != "MultiPoint") {
        return complain(what + " is a " + geometry.type + ", and not a point", leave_out());
      }
      if (geometry.points.empty()) return complain(what + " has an empty geometry", leave_out());
      if (geometry.points.size() > 1)
        return complain(what + " has more than one point", leave_out());
      const Point at = geometry.points[0];
      if (!is_finite(at)) {
        return complain(what + " has a coordinate that is not finite", leave_out());
      }
      heights_ = heights_ || geometry.has_z;
      station.position = {at.x + 0.0, at.y + 0.0};
      return true;
    } catch (const Error& error) {
      for (const Message& message : error.messages()) complaints_.add(message);
      return false;
    }
  }

  Wording leave_out() const {
    return setting(request_.source.where_setting) + " leaves stations out";
  }

  bool complain(Wording text, Wording hint = {}) {
    complaints_.add(features_.message(std::move(text), std::move(hint)));
    return false;
  }

  void require_some() const {
    if (!result_.stations.empty()) return;
    Wording text = "no stations in " + without_password(features_.file());
    if (!result_.filtered_ids.empty()) text += " pass " + setting(request_.source.where_setting);
    throw Error(Message{{}, 0, text, {}});
  }

  void keep_attributes(const Row& row) {
    guesses_.resize(row.fields.size());
    for (std::size_t i = 0; i < row.fields.size(); ++i) guesses_[i].see(row.fields[i]);
    result_.attributes.rows.emplace_back(row.fields.begin(), row.fields.end());
  }

  void finish_attributes() {
    if (!request_.attributes) return;
    for (std::size_t i = 0; i < features_.header().size(); ++i) {
      const FieldType type = features_.has_lines() ? guesses_[i].type() : features_.type(i);
      result_.attributes.fields.push_back({features_.header()[i], type});
    }
  }

  const StationsRequest& request_;
  Warnings& warnings_;
  Features features_;
  Complaints complaints_;
  StationsFile result_;
  std::size_t id_ = 0;
  std::optional<std::size_t> label_;
  std::size_t x_ = 0;
  std::size_t y_ = 0;
  bool by_geometry_ = false;
  bool heights_ = false;
  std::unordered_map<std::string, std::size_t> lines_;
  std::vector<FieldTypeGuess> guesses_;
};

}  // namespace

std::size_t station_id_field(const Features& features, const StationsRequest& request) {
  const auto& header = features.header();
  if (request.id.empty()) return find_field(header, known::station_ids).value_or(0);
  return require_field(header, request.id, setting("id"), features.file(), features.header_line());
}

StationsFile read_stations(const StationsRequest& request, Warnings& warnings) {
  return StationsReader(request, warnings).read();
}

std::string field_that_holds(const StationsRequest& request, const std::string& text) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(request.source.file, error)) return {};
  try {
    Warnings told_before;
    Features features(request.source, longest_field, told_before);
    Complaints complaints;
    while (features.next(complaints)) {
      const auto& fields = features.row().fields;
      for (std::size_t i = 0; i < fields.size(); ++i) {
        if (trimmed(fields[i]) == text) return features.header()[i];
      }
    }
  } catch (const Error&) {
    // The file was read before; what changed since is not what this hint is about.
  }
  return {};
}

}  // namespace thiessen
