#pragma once

#include <cstddef>
#include <string>
#include <unordered_set>
#include <vector>

#include "base/error.h"
#include "rainfall/network/reporting.h"
#include "rainfall/network/weights.h"
#include "study/study.h"

namespace thiessen {

/// What if some gauges closed and others opened: which stations of a study there are before and
/// after. The gauges that open are the last of the study's stations (StudyParts::opened).
class NetworkChange {
 public:
  /// `closed_from` is how messages name where the ids of `closed` come from, as
  /// StudyParts::opened_from names where gauges that open do. `left_out`: ids of the source's
  /// stations that a filter passes over. Throws Error for ids that the study lacks, with those that
  /// are most like them, and where no gauge is left. The study must outlive it. Cost: linear in the
  /// stations.
  NetworkChange(const Study& study, std::vector<std::string> closed,
                const std::unordered_set<std::string>& left_out, std::string closed_from);

  const ReportingStations& before() const { return before_; }
  const ReportingStations& after() const { return after_; }

  /// Warns of opened gauges at a place with others that are there after the change.
  void warn_of_shared_places(Warnings& warnings) const;
  /// Warns of gauges that open or close and weigh in no basin.
  void warn_of_no_effect(const std::vector<BasinWeights>& weights_before,
                         const std::vector<BasinWeights>& weights_after, Warnings& warnings) const;

 private:
  std::size_t first_opened() const;
  void close(const std::unordered_set<std::string>& left_out);
  Message unknown(const std::string& id, const std::unordered_set<std::string>& left_out) const;

  const Study& study_;
  std::vector<std::string> closed_;
  std::string closed_from_;
  ReportingStations before_;
  ReportingStations after_;
};

}  // namespace thiessen
