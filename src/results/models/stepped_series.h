#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "results/models/held_steps.h"
#include "results/models/model_series.h"
#include "results/models/series_times.h"

namespace thiessen {

/// A series whose steps follow each other at one length, as the text formats of models want it. It
/// is held until the step of the file is known, for only then is it known which steps lack.
class SteppedSeries : public ModelSeries {
 public:
  /// `format` is the name of the format in messages: `HYPE's Pobs.txt`.
  SteppedSeries(ModelSubject subject, std::string format);

  /// Throws Error where times go back, or have a clock only here and there, or are told in
  /// fractions of a second.
  void add(const IsoTime& time, std::span<const double> rainfall,
           std::span<const double> errors) final;
  /// Throws Error where there is no step, and where the series cannot be written in the format.
  void finish(Warnings& warnings) final;

 protected:
  /// The steps as they are written. Seconds are counted from the beginning of 1970 by the clock of
  /// the readings.
  struct Steps {
    std::int64_t begin = 0;   ///< when the first step begins
    std::int64_t length = 0;  ///< seconds in a step; 0 where they have no one length
    std::size_t count = 0;    ///< from the first step to the last, those that lack among them
    std::size_t lacking = 0;
    std::string first_lacking;  ///< when the first of these begins
  };

  const ModelSubject& subject() const { return subject_; }
  const std::string& format() const { return format_; }
  const SeriesTimes& times() const { return times_; }
  /// The moments of the steps as they were added, in seconds, each in its place.
  HeldSteps& held() { return held_; }

  /// Whether steps of months, and such as have no one length, are written too.
  virtual bool takes_any_steps() const { return false; }
  virtual void write(const Steps& steps, Warnings& warnings) = 0;

  /// Requires steps of a day or a whole part of it, in whole minutes, whose days begin at midnight,
  /// or where days begin that were summed over.
  void require_parts_of_days(const Steps& steps) const;
  /// Refuses readings whose unit is known and is none of these.
  void require_unit(std::span<const std::string_view> units) const;
  /// Says that the zone of the times is left out, where they have one.
  void tell_zone(Warnings& warnings) const;
  /// Says that steps which lack in the readings are written as missing, where some do.
  void tell_lacking(const Steps& steps, const std::string& missing, Warnings& warnings) const;

  using TakeStep = std::function<void(std::int64_t begin, std::span<const double> rainfall)>;
  /// Hands out the steps in their order; those that lack have NaN.
  void by_step(const Steps& steps, const TakeStep& take);
  /// Hands out the values of one basin after the other, those of steps that lack among them.
  void by_basin(const Steps& steps, const HeldSteps::TakeBasin& take);
  /// Appends the value with as many decimals as are wanted, or `missing` where there is none.
  void append_value(std::string& text, double value, std::string_view missing) const;

 private:
  Steps steps();
  std::size_t place_of(std::int64_t moment, const Steps& steps) const;

  ModelSubject subject_;
  std::string format_;
  SeriesTimes times_;
  HeldSteps held_;
  std::int64_t last_ = 0;
};

}  // namespace thiessen
