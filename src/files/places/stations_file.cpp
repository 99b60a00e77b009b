#include "files/places/stations_file.h"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/secrets.h"
#include "base/utf8.h"
#include "files/normals/elevation_column.h"
#include "files/normals/normal_columns.h"
#include "files/places/crs_fit.h"
#include "files/places/met_stations.h"
#include "files/places/station_fields.h"
#include "files/places/station_positions.h"
#include "files/tables/features.h"
#include "files/tables/skipped_lines.h"
#include "readings/stations/named_stations.h"
#include "text/field_names.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_field = std::size_t{1} << 20U;

/// Reads the stations of one file, a feature at a time.
class StationsReader {
 public:
  StationsReader(const StationsRequest& request, Warnings& warnings)
      : request_(request), warnings_(warnings), features_(request.source, longest_field, warnings) {
    result_.file = features_.file();
    result_.has_lines = features_.has_lines();
    fields_ = find_station_fields(features_, request_);
    positions_.emplace(features_, fields_, request_, complaints_);
    normals_.emplace(features_, request_.normal_field);
    elevations_.emplace(features_, request_.elevation_field);
    result_.elevation_field = elevations_->name();
  }

  StationsFile read() {
    features_.warn_of_oddities(warnings_);
    while (features_.next(complaints_)) {
      ++read_;
      if (features_.kept()) {
        add_station();
      } else {
        result_.filtered_ids.insert(id_of_row());
      }
    }
    drop_badly_placed();
    name_crs();
    complain_of_range(result_, complaints_);
    complaints_.throw_if_any();
    require_some();
    if (positions_->has_heights())
      warnings_.add({features_.file(), 0, "heights (Z) are passed over", {}});
    tell();
    finish_attributes();
    return std::move(result_);
  }

 private:
  std::string id_of_row() const {
    return fields_.id ? std::string(features_.row().fields[*fields_.id]) : std::to_string(read_);
  }

  void name_crs() {
    if (fields_.by_geometry) {
      const Features::Named named = features_.crs();
      result_.crs = named.crs;
      if (!named.crs) return;
      result_.crs_origin = named.by_option ? CrsOrigin::option
                           : named.implied ? CrsOrigin::implied
                                           : CrsOrigin::file;
    } else if (const auto wanted = features_.crs_of_columns()) {
      result_.crs = wanted;
      result_.crs_origin = CrsOrigin::option;
    } else if (fields_.are_degrees || !positions_->first_angle().empty()) {
      result_.crs = Crs::wgs84();
      result_.crs_origin = CrsOrigin::columns;
    }
  }

  void add_station() {
    const Row& row = features_.row();
    Station station{id_of_row(), {}, row.line};
    const Placing placing = positions_->read(station);
    if (placing == Placing::nowhere && request_.skip_unplaced) {
      if (unplaced_++ < stations_named) first_unplaced_.push_back(station.id);
      result_.filtered_ids.insert(std::move(station.id));
      return;
    }
    if (station.id.empty()) {
      complain("a station has no id");
      return;
    }
    if (const Station* const first = met_.meet(station.id))
      return meet_again(station, placing, *first);
    if (placing != Placing::good) {  // it was complained of, and is only to be met again
      badly_placed_.push_back(result_.stations.size());
      result_.stations.push_back(std::move(station));
      return;
    }
    if (fields_.label && !row.fields[*fields_.label].empty())
      result_.labels.emplace(station.id, std::string(row.fields[*fields_.label]));
    if (normals_->any()) {
      result_.normals.emplace(
          station.id, normals_->read(features_, "station " + quoted(station.id, 80), complaints_));
    }
    if (elevations_->any()) {
      result_.elevations.emplace(
          station.id,
          elevations_->read(features_, "station " + quoted(station.id, 80), complaints_));
    }
    result_.stations.push_back(std::move(station));
    if (request_.attributes) keep_attributes(row);
  }

  void drop_badly_placed() {
    auto bad = badly_placed_.begin();
    std::size_t at = 0;
    std::erase_if(result_.stations, [&](const Station&) {
      const bool is_bad = bad != badly_placed_.end() && *bad == at;
      if (is_bad) ++bad;
      ++at;
      return is_bad;
    });
  }

  /// A file of one row a reading gives each station again and again, at one place.
  void meet_again(const Station& station, Placing placing, const Station& first) {
    if (placing == Placing::good && station.position == first.position) {
      ++repeated_;
      return;
    }
    complain("station " + quoted(station.id, 80) + " is already in " +
                 (features_.has_lines() ? "line " : "feature ") + std::to_string(first.line) +
                 ", at another place",
             "ids must differ; " + setting("id") + " names another field, " +
                 setting(request_.source.where_setting) + " leaves stations out");
  }

  void complain(Wording text, Wording hint = {}) {
    complaints_.add(features_.message(std::move(text), std::move(hint)));
  }

  /// Says what was taken for granted, and what was passed over.
  void tell() {
    const std::string& file = features_.file();
    if (!fields_.id) {
      warnings_.add_notice({file,
                            0,
                            "it has no field that could be the id: its stations are numbered from "
                            "1, in its order",
                            {}});
    }
    if (repeated_ > 0) {
      warnings_.add_notice(
          {file,
           0,
           std::to_string(repeated_) + (repeated_ == 1 ? " row repeats" : " rows repeat") +
               " a station at its place: they make " + std::to_string(result_.stations.size()) +
               (result_.stations.size() == 1 ? " station" : " stations"),
           {}});
    }
    if (!positions_->first_angle().empty()) {
      warnings_.add_notice(
          {file,
           0,
           "coordinates in degrees, minutes and seconds are read: " + positions_->first_angle(),
           {}});
    }
    if (unplaced_ > 0) {
      warnings_.add(
          {file,
           0,
           (unplaced_ == 1 ? "a station without coordinates is"
                           : std::to_string(unplaced_) + " stations without coordinates are") +
               std::string(" passed over: ") + named(first_unplaced_, unplaced_),
           {}});
    }
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
  StationFields fields_;
  std::optional<StationPositions> positions_;
  std::optional<NormalColumns> normals_;
  std::optional<ElevationColumn> elevations_;
  MetStations met_{result_.stations};
  std::vector<std::size_t> badly_placed_;  ///< their places in the list, while it is made
  std::size_t read_ = 0;
  std::size_t repeated_ = 0;
  std::size_t unplaced_ = 0;
  std::vector<std::string> first_unplaced_;
  std::vector<FieldTypeGuess> guesses_;
};

}  // namespace

StationsFile read_stations(const StationsRequest& request, Warnings& warnings) {
  try {
    return StationsReader(request, warnings).read();
  } catch (const Error& error) {
    throw told_of_skip(error, request.source);
  }
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
