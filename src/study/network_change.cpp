#include "study/network_change.h"

#include <cstdint>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "base/utf8.h"
#include "study/similar_ids.h"
#include "text/similar_texts.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_id = 80;

StationIndex station_index(std::size_t i) {
  return StationIndex{static_cast<std::uint32_t>(i)};
}

ReportingStations stations_that_weigh(const std::vector<BasinWeights>& weights, std::size_t count) {
  ReportingStations weigh(count, false);
  for (const BasinWeights& basin : weights) {
    for (const StationWeight& s : basin.stations) weigh.set(s.station, true);
  }
  return weigh;
}

}  // namespace

NetworkChange::NetworkChange(const Study& study, std::vector<std::string> closed,
                             const std::unordered_set<std::string>& left_out,
                             std::string closed_from)
    : study_(study),
      closed_(std::move(closed)),
      closed_from_(std::move(closed_from)),
      before_(study.all_report()),
      after_(study.all_report()) {
  for (std::size_t s = first_opened(); s < before_.size(); ++s)
    before_.set(station_index(s), false);
  close(left_out);
}

std::size_t NetworkChange::first_opened() const {
  return study_.network().stations().size() - study_.parts().opened;
}

void NetworkChange::close(const std::unordered_set<std::string>& left_out) {
  const std::vector<Station>& stations = study_.network().stations();
  std::unordered_map<std::string_view, std::size_t> by_id;
  for (std::size_t s = 0; s < first_opened(); ++s) by_id.emplace(stations[s].id, s);
  Complaints complaints;
  for (const std::string& id : closed_) {
    const auto station = by_id.find(id);
    if (station == by_id.end()) {
      complaints.add(unknown(id, left_out));
    } else {
      after_.set(station_index(station->second), false);
    }
  }
  complaints.throw_if_any();
  if (after_.any()) return;
  throw Error({study_.parts().stations_file, 0, setting("without") + " closes every gauge",
               "leave one open, or open one with " + setting("with") + " X,Y"});
}

Message NetworkChange::unknown(const std::string& id,
                               const std::unordered_set<std::string>& left_out) const {
  const std::string& file = study_.parts().stations_file;
  const Wording text = setting("without") + " names station " + quoted(id, longest_id);
  if (left_out.contains(id))
    return {file, 0, text + ", which " + setting("stations_where") + " leaves out", ""};
  return {file, 0, text + ", which is not there",
          did_you_mean(similar_ids(id, study_.network().stations()))};
}

void NetworkChange::warn_of_shared_places(Warnings& warnings) const {
  const Network& network = study_.network();
  std::set<PlaceIndex> warned;
  for (std::size_t i = first_opened(); i < after_.size(); ++i) {
    const PlaceIndex place = network.place_of(station_index(i));
    if (!warned.insert(place).second) continue;
    std::string ids;
    std::size_t count = 0;
    for (const StationIndex s : network.stations_at(place)) {
      if (!after_[s]) continue;
      ids += (count++ == 0 ? "" : ", ") + quoted(network.stations()[index(s)].id, longest_id);
    }
    if (count > 1) {
      warnings.add({study_.parts().opened_from, 0,
                    "stations " + ids + " stand at one place and share its cell", ""});
    }
  }
}

void NetworkChange::warn_of_no_effect(const std::vector<BasinWeights>& weights_before,
                                      const std::vector<BasinWeights>& weights_after,
                                      Warnings& warnings) const {
  const std::vector<Station>& stations = study_.network().stations();
  const ReportingStations weighed = stations_that_weigh(weights_before, stations.size());
  const ReportingStations weighs = stations_that_weigh(weights_after, stations.size());
  const std::set<std::string_view> closed(closed_.begin(), closed_.end());
  for (std::size_t s = 0; s < stations.size(); ++s) {
    const bool is_opened = s >= first_opened();
    const std::string id = quoted(stations[s].id, longest_id);
    if (is_opened && !weighs[station_index(s)]) {
      warnings.add({study_.parts().opened_from, 0,
                    "the cell of " + id + " reaches into no basin: it changes nothing", ""});
    } else if (!is_opened && closed.contains(stations[s].id) && !weighed[station_index(s)]) {
      warnings.add({closed_from_, 0, "station " + id + " weighs in no basin: nothing changes", ""});
    }
  }
}

}  // namespace thiessen
