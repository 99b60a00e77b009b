#pragma once

#include <chrono>
#include <cstddef>
#include <exception>
#include <memory>
#include <optional>
#include <string>

#include "base/error.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/stamp.h"
#include "readings/steps/given_steps.h"

namespace thiessen {

/// Readings that pass over the steps that come once more, as a logger sends them again that has not
/// heard that they arrived. What came first stays. That others came again with other readings is a
/// warning, when the first of them comes; how many were passed over is said at the end.
class FreshReadings : public Readings {
 public:
  /// `file` is for messages. `warnings` must outlive this object.
  FreshReadings(std::unique_ptr<Readings> all, std::string file, Warnings& warnings)
      : all_(std::move(all)), file_(std::move(file)), warnings_(warnings) {}

  bool next(TimeStep& step) override;
  bool is_waiting(std::chrono::milliseconds patience) override;
  std::string unit() const override { return all_->unit(); }
  std::optional<Stamp> stamp() const override { return all_->stamp(); }
  double share_read() const override { return all_->share_read(); }

 private:
  bool read(TimeStep& step);
  bool is_fresh(const TimeStep& step);
  void conclude();

  std::unique_ptr<Readings> all_;
  std::string file_;
  Warnings& warnings_;
  GivenSteps given_;
  TimeStep ahead_;  ///< the next step, where it was read to see whether it has come
  bool has_ahead_ = false;
  bool at_end_ = false;
  std::exception_ptr failure_;  ///< met while looking ahead
  std::size_t again_ = 0;
  std::string first_again_;
  bool told_otherwise_ = false;
};

}  // namespace thiessen
