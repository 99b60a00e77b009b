#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/complaints.h"
#include "results/models/model_series.h"
#include "results/written.h"

namespace thiessen {

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A step of a test's series: a time as ISO 8601 writes it, and the basins' rainfall.
struct GivenStep {
  const char* time;
  std::vector<double> rainfall;
};

inline ModelSubject subject_of(std::vector<std::string> basins) {
  ModelSubject subject;
  subject.basins = std::move(basins);
  subject.made_by.software = "thiessen 9";
  subject.rainfall = "r.csv";
  subject.output = "out";
  return subject;
}

inline void add_all(ModelSeries& series, const std::vector<GivenStep>& steps) {
  for (const GivenStep& step : steps) series.add(parse_iso_time(step.time).time, step.rainfall, {});
}

/// What a series of one file writes of the steps; its warnings and notices go to `told`.
template <typename Series>
std::string series_text(const ModelSubject& subject, const std::vector<GivenStep>& steps,
                        Warnings& told) {
  return written([&](OutputFile& file) {
    Series series(file, subject);
    add_all(series, steps);
    series.finish(told);
  });
}

template <typename Series>
std::string series_text(const ModelSubject& subject, const std::vector<GivenStep>& steps) {
  Warnings untold;
  return series_text<Series>(subject, steps, untold);
}

/// The first complaint of a series.
template <typename Series>
std::string series_fault(const ModelSubject& subject, const std::vector<GivenStep>& steps) {
  return complaint_of([&] { series_text<Series>(subject, steps); });
}

}  // namespace thiessen
