#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "rainfall/network/network.h"

namespace thiessen {

/// Finds the station that a text in the rainfall names. Ids are compared exactly as text; if that
/// finds none, they are compared once more with the text's surrounding blanks left out.
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

  /// The ids must outlive this object.
  ReadingsStations(std::span<const Station> stations, std::span<const std::string> passed_over);

  Found find(std::string_view text) const;
  std::span<const Station> all() const { return stations_; }
  const std::string& id(StationIndex station) const { return stations_[index(station)].id; }

 private:
  std::span<const Station> stations_;
  std::unordered_map<std::string_view, Found> by_id_;
};

}  // namespace thiessen
