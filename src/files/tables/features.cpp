#include "files/tables/features.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/utf8.h"
#include "files/tables/csv_file.h"
#include "files/tables/dwd_station_list.h"
#include "files/tables/ghcn_station_list.h"
#include "files/tables/netcdf_station_list.h"
#include "files/tables/netcdf_stations.h"
#include "files/tables/sheet_file.h"
#include "files/tables/swat_station_list.h"
#include "gdal/layers/geometry_text.h"
#include "gdal/layers/opening.h"
#include "text/field_names.h"
#include "text/known_names.h"
#include "text/last_line.h"

namespace thiessen {
namespace {

std::unique_ptr<Table> open_rows(const Source& source, std::size_t longest_field,
                                 Warnings& warnings) {
  CsvLimits limits;
  limits.field_bytes = longest_field;
  limits.row_bytes = std::max(limits.row_bytes, longest_field);
  return open_csv(source.file, source.csv, limits, warnings);
}

}  // namespace

struct Features::Loaded {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::size_t> lines;
  std::size_t next = 0;
  std::optional<Error> error;
};

Features::Features(const Source& source, std::size_t longest_field, Warnings& warnings)
    : source_(source) {
  if (is_netcdf_of_stations(source.file)) {
    table_ = std::make_unique<NetcdfStationList>(source.file);
    warnings.add_notice({source.file, 0, read_as_netcdf, {}});
  } else if (auto sheet = open_sheet(source, warnings)) {
    table_ = std::move(sheet);
    wkt_ = find_field(header(), known::geometries);
  } else if (read_by_gdal(source.file)) {
    auto layer =
        std::make_unique<Layer>(source.file, source.layer, source.layer_setting, &warnings);
    layer_ = layer.get();
    table_ = std::move(layer);
  } else if (is_ghcn_station_list(source.file)) {
    table_ = std::make_unique<GhcnStationList>(source.file);
    tell_of_last_line(source.file, warnings);
    warnings.add_notice({source.file, 0, "read as GHCN-Daily's list of stations", {}});
  } else if (is_dwd_station_list(source.file)) {
    table_ = std::make_unique<DwdStationList>(source.file);
    tell_of_last_line(source.file, warnings);
    warnings.add_notice({source.file, 0, "read as DWD's list of stations", {}});
  } else if (const SwatFile kind = swat_file_called(source.file); kind != SwatFile::none) {
    table_ = std::make_unique<SwatStationList>(source.file, kind);
    tell_of_last_line(source.file, warnings);
    warnings.add_notice({source.file, 0, "read as gauges of SWAT or SWAT+", {}});
  } else {
    if (!source.layer.empty()) throw no_layers(source);
    table_ = open_rows(source, longest_field, warnings);
    wkt_ = find_field(header(), known::geometries);
    mark_ = table_->decimal_mark();
  }
  if (source.where.empty()) return;
  if (layer_ == nullptr) load_rows();
  std::vector<FieldName> fields;
  for (std::size_t i = 0; i < header().size(); ++i) fields.push_back({header()[i], type(i)});
  if (loaded_) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      FieldTypeGuess guess;
      for (const auto& row : loaded_->rows) guess.see(row[i]);
      fields[i].type = guess.type();
    }
  }
  filter_ = std::make_unique<AttributeFilter>(source.where, source.where_setting, file(), fields);
}

Features::~Features() = default;

void Features::load_rows() {
  loaded_ = std::make_unique<Loaded>();
  Row row;
  try {
    while (table_->next(row)) {
      loaded_->rows.emplace_back(row.fields.begin(), row.fields.end());
      loaded_->lines.push_back(row.line);
    }
  } catch (const Error& error) {
    loaded_->error = error;
  }
}

bool Features::next_loaded() {
  if (loaded_->next == loaded_->rows.size()) {
    if (loaded_->error) throw Error(*std::exchange(loaded_->error, std::nullopt));
    return false;
  }
  const auto& fields = loaded_->rows[loaded_->next];
  row_.fields.assign(fields.begin(), fields.end());
  row_.line = loaded_->lines[loaded_->next++];
  return true;
}

bool Features::next(Complaints& complaints) {
  try {
    if (!(loaded_ ? next_loaded() : table_->next(row_))) return false;
  } catch (const Error& error) {
    complaints.add(error);
    return false;
  }
  kept_ = filter_ == nullptr || filter_->keeps(row_);
  return true;
}

bool Features::has_geometry() const {
  return layer_ != nullptr ? layer_->has_geometry() : wkt_.has_value();
}

bool Features::may_not_be_geometries() const {
  return layer_ == nullptr && wkt_ && !same_name(header()[*wkt_], known::geometries.front());
}

FieldType Features::type(std::size_t field) const {
  return layer_ != nullptr ? layer_->types()[field] : FieldType::text;
}

GeometryRecord Features::geometry() {
  if (layer_ != nullptr) return layer_->geometry();
  const std::string_view text = row_.fields[*wkt_];
  auto read = geometry_of_text(std::string(text));
  if (!read) throw Error(message("not a geometry in WKT: " + quoted(text, 60)));
  if (read->srid != 0 && srid_ != 0 && read->srid != srid_) {
    throw Error(message("its SRID is " + std::to_string(read->srid) + ", and others' before it " +
                            std::to_string(srid_),
                        "a file's geometries have one CRS"));
  }
  if (read->srid != 0) srid_ = read->srid;
  return std::move(read->geometry);
}

std::string Features::place() const {
  if (layer_ == nullptr) return {};
  if (layer_->is_geojson()) return "features[" + std::to_string(row_.line - 1) + "].geometry";
  return "feature " + std::to_string(row_.line);
}

Message Features::message(Wording text, Wording hint) const {
  const std::string where = place();
  return {file(), has_lines() ? row_.line : 0,
          where.empty() ? std::move(text) : where + ": " + text, std::move(hint)};
}

Features::Named Features::crs() const {
  Named named;
  if (layer_ != nullptr) {
    named.crs = layer_->crs();
    named.implied = layer_->crs_implied();
  } else if (srid_ != 0) {
    named.crs = Crs::from_text("EPSG:" + std::to_string(srid_), file());
  }
  if (source_.crs.empty()) {
    if (named.implied) named.crs = Crs::wgs84();
    return named;
  }
  const Crs wanted = *crs_of_columns();
  if (named.crs && !named.crs->same_as(wanted)) {
    throw Error(Message{
        file(), 0,
        "its CRS is " + named.crs->name() + ", and not " + wanted.name() + " as " +
            setting(source_.crs_setting) + " says",
        "leave " + setting(source_.crs_setting) + " out: it is for files that name no CRS"});
  }
  named.by_option = !named.crs;
  named.crs = wanted;
  named.implied = false;
  return named;
}

std::optional<Crs> Features::crs_of_columns() const {
  if (source_.crs.empty()) return std::nullopt;
  return Crs::from_text(source_.crs, setting(source_.crs_setting));
}

void Features::warn_of_oddities(Warnings& warnings) const {
  if (layer_ == nullptr) return;
  for (const std::string& oddity : layer_->oddities()) warnings.add({file(), 0, oddity, {}});
}

}  // namespace thiessen
