#include "files/rainfall/event_readings.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "files/places/station_fields.h"
#include "files/tables/features.h"
#include "readings/readings_layout.h"
#include "readings/stations/heard_stations.h"
#include "readings/times/time_columns.h"
#include "text/field_names.h"
#include "text/table.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_field = std::size_t{1} << 20U;
ReadingsLayout layout() {
  return {true, TimeColumns(0), 1, 2};
}

/// The stations that the filter keeps, as a long table of one time.
class EventTable : public Table {
 public:
  EventTable(const StationsRequest& request, const std::string& value_field)
      : request_(request),
        value_field_(value_field),
        features_(request_.source, longest_field, told_before_),
        id_(find_station_fields(features_, request_).id),
        value_(require_field(features_.header(), value_field_, setting("value_field"),
                             features_.file(), features_.header_line())),
        header_{"time", id_ ? features_.header()[*id_] : "id", features_.header()[value_]} {}

  const std::string& file() const override { return features_.file(); }
  const std::vector<std::string>& header() const override { return header_; }
  DecimalMark decimal_mark() const override { return features_.decimal_mark(); }
  std::size_t header_line() const override { return features_.header_line(); }

  bool next(Row& row) override {
    do {
      if (!features_.next(complaints_)) {
        complaints_.throw_if_any();
        return false;
      }
      number_ = std::to_string(++read_);
    } while (!features_.kept());
    const Row& of_station = features_.row();
    row.line = of_station.line;
    row.padded = false;
    row.fields = {event_time, id_ ? of_station.fields[*id_] : number_, of_station.fields[value_]};
    return true;
  }

  std::unique_ptr<Table> again() const override {
    return std::make_unique<EventTable>(request_, value_field_);
  }

 private:
  StationsRequest request_;
  std::string value_field_;
  Warnings told_before_;  // when the stations were read
  Features features_;
  Complaints complaints_;
  std::optional<std::size_t> id_;
  std::size_t value_;
  std::vector<std::string> header_;
  std::size_t read_ = 0;
  std::string number_;  ///< of the feature last read, which is its id where no field is
};

}  // namespace

std::unique_ptr<Readings> open_event(const StationsRequest& request,
                                     std::span<const Station> stations,
                                     std::span<const std::string> passed_over,
                                     const ReadingsOptions& options, Warnings& warnings) {
  return open_long_readings(std::make_unique<EventTable>(request, options.value_field), layout(),
                            stations, passed_over, options, warnings);
}

ReportingStations stations_in_event(const StationsRequest& request,
                                    std::span<const Station> stations,
                                    std::span<const std::string> passed_over,
                                    const ReadingsOptions& options) {
  const ReadingsStations known(stations, passed_over, {options.ids_as_numbers, {}});
  HeardStations heard(known);
  try {
    EventTable table(request, options.value_field);
    heard.look_through(table, layout(), options);
  } catch (const Error&) {
    return ReportingStations(stations.size(), true);
  }
  return heard.heard();
}

}  // namespace thiessen
