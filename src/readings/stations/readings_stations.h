#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "base/wording.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// How the ids in RAINFALL are joined to those of the stations.
struct IdJoin {
  /// Ids of digits that differ by leading zeros, or by a fraction of zeros (7 and 007 and 7.0), are
  /// one.
  bool as_numbers = false;
  /// Finds another column of the stations' source that holds this id, for a hint; may be empty.
  std::function<std::string(const std::string& id)> column_of;
};

/// Finds the station that a text in the rainfall names. Ids are compared exactly as text; if that
/// finds none, they are compared once more with the text's surrounding blanks left out, and as
/// numbers where the user wants it.
class ReadingsStations {
 public:
  enum class Standing : std::uint8_t {
    known,
    passed_over,  ///< in the stations' file, but left out by the user's filter
    unknown,
  };
  struct Found {
    Standing standing = Standing::unknown;
    StationIndex station = {};  ///< only if known
  };

  /// The ids must outlive this object. Throws Error where ids are to be compared as numbers and two
  /// stations have the same.
  ReadingsStations(std::span<const Station> stations, std::span<const std::string> passed_over,
                   IdJoin join = {});

  Found find(std::string_view text) const;
  /// Why an id may be unknown though its station is there.
  enum class Cause : std::uint8_t { none, zeros, spelling, column };
  struct Meant {
    Cause cause = Cause::none;
    Wording hint;  ///< what may be done about it
  };
  /// Whether an unknown id looks like that of a station in another spelling, be it passed over or
  /// not, or stands in another column of the stations. Cost: the stations.
  Meant meant_by(std::string_view text) const;
  std::span<const Station> all() const { return stations_; }
  const std::string& id(StationIndex station) const { return stations_[index(station)].id; }

 private:
  static Meant spelt_as(std::string_view text, const std::string& id);
  void enter_numbers(std::span<const std::string> passed_over);

  std::span<const Station> stations_;
  std::span<const std::string> passed_over_;
  std::unordered_map<std::string_view, Found> by_id_;
  std::unordered_map<std::string_view, Found> by_number_;  // empty unless ids are joined so
  IdJoin join_;
};

}  // namespace thiessen
