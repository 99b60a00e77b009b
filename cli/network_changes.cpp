#include "cli/network_changes.h"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "base/error.h"
#include "base/utf8.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"
#include "cli/similar_ids.h"
#include "text/similar_texts.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t longest_id = 80;

Message unknown(const std::string& id, const Inputs& inputs) {
  const StudyFiles& study = inputs.study();
  const std::string text = "--without names station " + quoted(id, longest_id);
  if (study.filtered_ids.contains(id))
    return {study.stations_file, 0, text + ", which --stations-where leaves out", ""};
  return {study.stations_file, 0, text + ", which is not there",
          did_you_mean(similar_ids(id, inputs.network().stations()))};
}

}  // namespace

namespace {

std::vector<bool> stations_that_weigh(const std::vector<BasinWeights>& weights, std::size_t count) {
  std::vector<bool> weigh(count, false);
  for (const BasinWeights& basin : weights) {
    for (const StationWeight& s : basin.stations) weigh[index(s.station)] = true;
  }
  return weigh;
}

}  // namespace

void NetworkChanges::warn_of_no_effect(const Inputs& inputs,
                                       const std::vector<BasinWeights>& before,
                                       const std::vector<BasinWeights>& after,
                                       Warnings& warnings) const {
  const std::vector<Station>& stations = inputs.network().stations();
  const std::vector<bool> weighed = stations_that_weigh(before, stations.size());
  const std::vector<bool> weighs = stations_that_weigh(after, stations.size());
  const std::set<std::string_view> closed(closed_.begin(), closed_.end());
  for (std::size_t s = 0; s < stations.size(); ++s) {
    const bool is_opened = s + opened_.size() >= stations.size();
    const std::string id = quoted(stations[s].id, longest_id);
    if (is_opened && !weighs[s]) {
      warnings.add(
          {"--with", 0, "the cell of " + id + " reaches into no basin: it changes nothing", ""});
    } else if (!is_opened && closed.contains(stations[s].id) && !weighed[s]) {
      warnings.add({"--without", 0, "station " + id + " weighs in no basin: nothing changes", ""});
    }
  }
}

void NetworkChanges::declare(OptionList& options) {
  OptionGroup what_if = options.group("What if", *this);
  what_if.add("--without", texts(closed_, "ID"),
              "what if this station closed: the weights with columns area_km2_after and "
              "weight_after; may be repeated");
  what_if.add("--with", points(opened_),
              "what if a gauge opened here, in the coordinates of STATIONS; the first is called "
              "'with 1'; may be repeated, and beside --without");
}

ReportingStations NetworkChanges::before(const Inputs& inputs) const {
  ReportingStations reports = inputs.all_report();
  for (std::size_t s = reports.size() - opened_.size(); s < reports.size(); ++s)
    reports.set(StationIndex{static_cast<std::uint32_t>(s)}, false);
  return reports;
}

ReportingStations NetworkChanges::after(const Inputs& inputs) const {
  const std::vector<Station>& stations = inputs.network().stations();
  std::unordered_map<std::string_view, std::size_t> by_id;
  for (std::size_t s = 0; s + opened_.size() < stations.size(); ++s)
    by_id.emplace(stations[s].id, s);
  ReportingStations reports = inputs.all_report();
  std::set<std::string_view> seen;
  Complaints complaints;
  for (const std::string& id : closed_) {
    if (!seen.insert(id).second)
      throw UsageError{"--without names station " + quoted(id, longest_id) + " twice", ""};
    const auto station = by_id.find(id);
    if (station == by_id.end()) {
      complaints.add(unknown(id, inputs));
    } else {
      reports.set(StationIndex{static_cast<std::uint32_t>(station->second)}, false);
    }
  }
  complaints.throw_if_any();
  if (!reports.any()) {
    throw Error({inputs.study().stations_file, 0, "--without closes every gauge",
                 "leave one open, or open one with --with X,Y"});
  }
  return reports;
}

void NetworkChanges::warn_of_shared_places(const Inputs& inputs, Warnings& warnings) const {
  const Network& network = inputs.network();
  const ReportingStations is_there = after(inputs);
  std::set<PlaceIndex> warned;
  for (std::size_t i = network.stations().size() - opened_.size(); i < is_there.size(); ++i) {
    const PlaceIndex place = network.place_of(StationIndex{static_cast<std::uint32_t>(i)});
    if (!warned.insert(place).second) continue;
    std::string ids;
    std::size_t count = 0;
    for (const StationIndex s : network.stations_at(place)) {
      if (!is_there[s]) continue;
      ids += (count++ == 0 ? "" : ", ") + quoted(network.stations()[index(s)].id, longest_id);
    }
    if (count > 1)
      warnings.add({"--with", 0, "stations " + ids + " stand at one place and share its cell", ""});
  }
}

}  // namespace thiessen::cli
