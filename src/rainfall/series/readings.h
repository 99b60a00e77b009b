#pragma once

#include <chrono>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/iso_time.h"
#include "rainfall/series/stamp.h"

namespace thiessen {

/// What a time says that is not written as ISO 8601 wants it.
struct WrittenTime {
  ParsedTime parsed;  ///< by the calendar; with a fault where that is not known
  Wording fault;      ///< what is wrong with the time, behind its text; may be empty
  Wording hint;
  bool breaks_format = false;  ///< whether it contradicts how the times of its file are written

  /// Whether it is none at all where the times of its file are.
  bool is_no_time() const { return breaks_format && parsed.fault == IsoTimeFault::form; }
};

/// What the gauges read at one time; NaN where a gauge is silent.
struct TimeStep {
  std::string time;  ///< as the file writes it
  std::span<const double>
      readings;  ///< one for each station, in the stations' order; valid until the next step
  std::size_t line = 0;  ///< where the time first came; 0 where that is not known
  /// What the time says; nothing where it is to be read as ISO 8601.
  std::optional<WrittenTime> written = {};
};

/// The time of a step by the calendar.
ParsedTime calendar_time(std::string_view time, const std::optional<WrittenTime>& written);

/// A table of readings, read one time step after the other in the order in which the times first
/// came.
class Readings {
 public:
  virtual ~Readings() = default;
  /// Reads the next step into `step`; returns false at the end. Throws Error where the input is
  /// bad.
  virtual bool next(TimeStep& step) = 0;
  /// Whether the next step, or the end, has not come yet, nor comes within `patience`: then `next`
  /// would wait for it. Only of what is read from a pipe is it ever true. The step before is no
  /// longer valid.
  virtual bool is_waiting(std::chrono::milliseconds /*patience*/) { return false; }
  /// What the readings are in, such as mm; empty where that is not known.
  virtual std::string unit() const { return {}; }
  /// What the times are of their steps, where the input itself says it.
  virtual std::optional<Stamp> stamp() const { return std::nullopt; }
  /// The share of the input that has been read, from 0 to 1; NaN where its length is not known.
  /// Only the thread that reads may ask; other threads ask WatchedReadings.
  virtual double share_read() const { return std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace thiessen
