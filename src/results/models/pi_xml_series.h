#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/file.h"
#include "results/models/stepped_series.h"

namespace thiessen {

/// Series as Delft-FEWS exchanges them in its published interface (PI): a series for each basin,
/// whose location is the basin's id and whose parameter is P, with an event at the end of each
/// step. Steps of one length in seconds are equidistant, others are not; missing values are
/// -999.0, as missVal says.
///
/// Source: Deltares, Delft-FEWS Documentation, "TimeSeries reader for the Delft-Fews Published
/// Interface XML format files", and the schema that it names, pi_timeseries.xsd.
class PiXmlSeries : public SteppedSeries {
 public:
  /// The file must outlive it. Throws Error where an id has characters that XML cannot hold.
  PiXmlSeries(OutputFile& file, ModelSubject subject);

 private:
  bool takes_any_steps() const override { return true; }
  void write(const Steps& steps, Warnings& warnings) override;
  std::vector<std::int64_t> ends(const Steps& steps, Warnings& warnings);
  void write_head();
  void write_basin(const Steps& steps, std::span<const std::int64_t> ends, std::size_t basin,
                   std::span<const double> values);

  OutputFile& file_;
};

}  // namespace thiessen
