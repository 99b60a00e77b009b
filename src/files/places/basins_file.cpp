#include "files/places/basins_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/secrets.h"
#include "base/utf8.h"
#include "files/normals/elevation_column.h"
#include "files/normals/normal_columns.h"
#include "files/places/crs_fit.h"
#include "files/tables/features.h"
#include "files/tables/skipped_lines.h"
#include "geometry/shape_points.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_field = std::size_t{256} << 20U;

/// A feature that was read before it is known which field holds the id.
struct Candidate {
  std::vector<std::string> ids;  ///< one for each field that may be the id
  std::size_t number = 0;
  std::size_t line = 0;
  std::string place;
  MultiPolygon polygons;
  std::vector<double> normals;
  double elevation = 0;
};

class BasinsReader {
 public:
  BasinsReader(const BasinsRequest& request, Warnings& warnings)
      : request_(request), warnings_(warnings), features_(request.source, longest_field, warnings) {
    result_.file = features_.file();
    if (!features_.has_geometry()) {
      throw Error(Message{features_.file(), features_.header_line(), "holds no polygons",
                          features_.has_lines() ? "a CSV of basins has a column named WKT" : ""});
    }
    find_id_fields();
    normals_.emplace(features_, request_.normal_field);
    elevations_.emplace(features_, request_.elevation_field,
                        setting("elevation") +
                            " RASTER has the ground's elevations, and basins "
                            "need none then");
  }

  BasinsFile read() {
    features_.warn_of_oddities(warnings_);
    while (features_.next(complaints_)) {
      ++number_;
      if (features_.kept()) add_feature();
    }
    name_crs();
    if (!complaints_.empty()) {
      group(chosen_id());
      complain_of_range(result_, complaints_);
    }
    complaints_.throw_if_any();
    if (candidates_.empty()) {
      throw Error(
          Message{{},
                  0,
                  "no basins in " + without_password(features_.file()) +
                      (number_ > 0 ? " pass " + setting(request_.source.where_setting) : ""),
                  {}});
    }
    if (heights_) warnings_.add({features_.file(), 0, "heights (Z) are passed over", {}});
    const auto id = chosen_id();
    if (!id && !fields_.empty()) tell_of_numbers();
    group(id);
    return std::move(result_);
  }

 private:
  void name_crs() {
    const Features::Named named = features_.crs();
    result_.crs = named.crs;
    if (!named.crs) return;
    result_.crs_origin = named.by_option ? CrsOrigin::option
                         : named.implied ? CrsOrigin::implied
                                         : CrsOrigin::file;
  }

  void find_id_fields() {
    const auto& header = features_.header();
    if (!request_.id.empty()) {
      fields_ = {require_field(header, request_.id, setting("basin_id"), features_.file(),
                               features_.header_line())};
      return;
    }
    for (const std::string_view name : known::basin_ids) {
      if (const auto field = find_field(header, {&name, 1})) fields_.push_back(*field);
    }
  }

  void add_feature() {
    Candidate candidate;
    const Row& row = features_.row();
    for (const std::size_t field : fields_) candidate.ids.emplace_back(row.fields[field]);
    candidate.number = number_;
    candidate.line = features_.has_lines() ? row.line : 0;
    candidate.place = features_.place();
    try {
      GeometryRecord geometry = features_.geometry();
      if (!is_area(geometry, candidate)) return;
      heights_ = heights_ || geometry.has_z;
      candidate.polygons = std::move(geometry.polygons);
    } catch (const Error& error) {
      for (const Message& message : error.messages()) complaints_.add(message);
      return;
    }
    if (!request_.id.empty() && candidate.ids[0].empty()) {
      complaints_.add(features_.message("basin has no " + quoted(request_.id, 80)));
      return;
    }
    if (normals_->any()) {
      candidate.normals = normals_->read(
          features_, candidate.ids.empty() ? "basin" : "basin " + quoted(candidate.ids[0], 80),
          complaints_);
    }
    if (elevations_->any()) {
      candidate.elevation = elevations_->read(
          features_, candidate.ids.empty() ? "basin" : "basin " + quoted(candidate.ids[0], 80),
          complaints_);
    }
    candidates_.push_back(std::move(candidate));
  }

  bool is_area(const GeometryRecord& geometry, const Candidate& candidate) {
    const auto named = std::find_if(candidate.ids.begin(), candidate.ids.end(),
                                    [](const std::string& id) { return !id.empty(); });
    const std::string what = named == candidate.ids.end() ? "basin" : "basin " + quoted(*named, 80);
    std::string text;
    if (geometry.type.empty()) {
      text = " has no geometry";
    } else if (geometry.type != "Polygon" && geometry.type != "MultiPolygon") {
      text = " is a " + geometry.type + ", and not a polygon";
    } else if (geometry.polygons.empty()) {
      text = " has an empty geometry";
    } else if (!every_point(geometry.polygons, is_finite)) {
      text = " has a coordinate that is not finite";
    }
    if (!text.empty()) complain(what + text);
    return text.empty();
  }

  void complain(Wording text) {
    complaints_.add(features_.message(
        std::move(text), setting(request_.source.where_setting) + " leaves features out"));
  }

  /// The field that holds the id: the one that is given by name, or the first whose values are all
  /// there and all different. Nothing where there is none: the feature's number is then its id.
  std::optional<std::size_t> chosen_id() const {
    if (!request_.id.empty()) return 0;
    for (std::size_t field = 0; field < fields_.size(); ++field) {
      std::unordered_set<std::string_view> seen;
      const bool good =
          std::all_of(candidates_.begin(), candidates_.end(), [&](const Candidate& c) {
            return !c.ids[field].empty() && seen.insert(c.ids[field]).second;
          });
      if (good) return field;
    }
    return std::nullopt;
  }

  void tell_of_numbers() {
    const std::string name = features_.header()[fields_.front()];
    warnings_.add_notice({features_.file(), 0,
                          "its basins are numbered, for " + quoted(name, 80) +
                              " is not there, or not another one, for each feature",
                          setting("basin_id", name) + " makes one basin of those that share it"});
  }

  void group(std::optional<std::size_t> field) {
    std::unordered_map<std::string, std::size_t> known;
    for (Candidate& candidate : candidates_) {
      std::string id = field ? candidate.ids[*field] : std::to_string(candidate.number);
      const auto [at, fresh] = known.emplace(id, result_.basins.size());
      if (fresh) {
        std::string place = "basin " + quoted(id, 80);
        if (!candidate.place.empty()) place += " (" + candidate.place + ")";
        result_.basins.push_back({std::move(id), std::move(place), candidate.line, {}});
      }
      if (normals_->any()) take_normals(candidate, result_.basins[at->second]);
      if (elevations_->any()) take_elevation(candidate, result_.basins[at->second]);
      MultiPolygon& polygons = result_.basins[at->second].polygons;
      std::move(candidate.polygons.begin(), candidate.polygons.end(), std::back_inserter(polygons));
    }
  }

  /// The features of one basin have the same normals.
  void take_normals(const Candidate& candidate, const RawBasin& basin) {
    const auto [at, fresh] = result_.normals.emplace(basin.id, candidate.normals);
    const auto is_same = [](double a, double b) {
      return a == b || (std::isnan(a) && std::isnan(b));
    };
    if (fresh || std::equal(at->second.begin(), at->second.end(), candidate.normals.begin(),
                            candidate.normals.end(), is_same))
      return;
    throw Error({features_.file(), candidate.line,
                 basin.place + " has other normals in another of its features",
                 "the features of one basin have the same normals"});
  }

  /// The features of one basin have its mean elevation.
  void take_elevation(const Candidate& candidate, const RawBasin& basin) {
    const auto [at, fresh] = result_.elevations.emplace(basin.id, candidate.elevation);
    const double before = at->second;
    if (fresh || before == candidate.elevation ||
        (std::isnan(before) && std::isnan(candidate.elevation)))
      return;
    throw Error({features_.file(), candidate.line,
                 basin.place + " has another elevation in another of its features",
                 "the features of one basin have the basin's mean elevation"});
  }

  const BasinsRequest& request_;
  Warnings& warnings_;
  Features features_;
  Complaints complaints_;
  BasinsFile result_;
  std::vector<std::size_t> fields_;
  std::optional<NormalColumns> normals_;
  std::optional<ElevationColumn> elevations_;
  std::vector<Candidate> candidates_;
  std::size_t number_ = 0;
  bool heights_ = false;
};

}  // namespace

BasinsFile read_basins(const BasinsRequest& request, Warnings& warnings) {
  try {
    return BasinsReader(request, warnings).read();
  } catch (const Error& error) {
    throw told_of_skip(error, request.source);
  }
}

}  // namespace thiessen
