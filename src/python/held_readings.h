#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "rainfall/network/reporting.h"
#include "rainfall/series/readings.h"

namespace thiessen::python {

/// Readings in the caller's memory, which are not copied: a row for each step and in it a column
/// for each station that was given, in their order. NaN where a gauge is silent.
struct Matrix {
  const double* first = nullptr;
  std::size_t steps = 0;
  std::size_t stations = 0;

  std::span<const double> operator[](std::size_t step) const {
    return {first + step * stations, stations};
  }
};

/// Readings in memory, with the time of each row as text where times are asked for.
struct GivenReadings {
  Matrix matrix;
  std::vector<std::string> times;
};

/// Throws Error with the readings that no gauge can have; `ids` are those of the stations, one for
/// each column.
void check_readings(const Matrix& readings, const std::vector<std::string>& ids);

/// The stations that have at least one reading.
ReportingStations heard_in(const Matrix& readings);

/// The rows of a matrix with the network's stations alone. Where these are all stations that were
/// given, a row is the caller's own memory.
class HeldRows {
 public:
  HeldRows(const Matrix& readings, const std::vector<std::size_t>& columns)
      : readings_(readings), columns_(columns) {}

  std::size_t size() const { return readings_.steps; }
  std::span<const double> row(std::size_t step, std::vector<double>& buffer) const {
    const std::span<const double> whole = readings_[step];
    if (columns_.size() == whole.size()) return whole;
    buffer.resize(columns_.size());
    for (std::size_t i = 0; i < columns_.size(); ++i) buffer[i] = whole[columns_[i]];
    return buffer;
  }

 private:
  const Matrix& readings_;
  const std::vector<std::size_t>& columns_;
};

/// The rows of readings in memory as a table of readings. A step's line is its row, from 1. Both
/// arguments must outlive it.
class DatedRows : public Readings {
 public:
  /// Requires a time for each row, or none at all: rows are then called by their numbers.
  DatedRows(const GivenReadings& readings, const std::vector<std::size_t>& columns)
      : rows_(readings.matrix, columns), times_(readings.times) {}

  bool next(TimeStep& step) override;

 private:
  HeldRows rows_;
  const std::vector<std::string>& times_;
  std::vector<double> buffer_;
  std::size_t next_ = 0;
};

}  // namespace thiessen::python
