#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/stamp.h"
#include "readings/readings_reader.h"
#include "readings/units/rain_unit.h"

namespace thiessen {

/// What is done to the readings of a file, so that they come in one unit.
struct AmountConversion {
  RainFactor factor;
  std::string unit;        ///< of what comes out; empty where it is not known
  double millimetres = 1;  ///< that a reading of 1 stands for, as the file writes it; 1 where the
                           ///< unit is not known
};

/// The column of values of a long table, or all of a wide one.
struct ValueColumn {
  std::string file;
  std::size_t line = 0;  ///< of the header
  std::string name;      ///< empty for a wide table
  std::string unit;      ///< what a row below the header says; empty where there is none
  std::vector<std::string> lines_above = {};  ///< what stands above the header
};

/// Settles what is done to readings by what the user says and by the unit below their column's
/// name, in it, or else in a line above the header, which is believed, and told in a notice where
/// it means a conversion. Throws Error where another unit is wanted and that of the readings is not
/// known, and where lines above the header say several.
AmountConversion conversion_of(const ReadingsOptions& options, const ValueColumn& column,
                               Warnings& warnings);
/// The same for readings whose unit is known.
AmountConversion conversion_from(const RainUnit& unit, const ReadingsOptions& options);

/// Readings, each multiplied by a factor. Cost: one operation a gauge and step.
class ConvertedReadings : public Readings {
 public:
  ConvertedReadings(std::unique_ptr<Readings> all, AmountConversion conversion)
      : all_(std::move(all)), conversion_(std::move(conversion)) {}

  bool next(TimeStep& step) override;
  bool is_waiting(std::chrono::milliseconds patience) override {
    return all_->is_waiting(patience);
  }
  std::string unit() const override { return conversion_.unit; }
  std::optional<Stamp> stamp() const override { return all_->stamp(); }
  double share_read() const override { return all_->share_read(); }

 private:
  std::unique_ptr<Readings> all_;
  AmountConversion conversion_;
  std::vector<double> amounts_;
};

/// The readings as the conversion has them; themselves where it neither changes nor names anything.
std::unique_ptr<Readings> converted(std::unique_ptr<Readings> readings,
                                    const AmountConversion& conversion);

}  // namespace thiessen
