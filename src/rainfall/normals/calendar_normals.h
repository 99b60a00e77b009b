#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "rainfall/normals/series_normals.h"

namespace thiessen {

/// A calendar month, from 0, of a year.
struct MonthOfYear {
  int year = 0;
  std::size_t month = 0;
};

/// Finds the normals of places from one series, of the year and of each calendar month, in one
/// pass. Memory and cost: twice those of SeriesNormals, and a bit a place for each month of each
/// year.
class CalendarNormals {
 public:
  static constexpr std::size_t months = 12;
  /// In so many years a place has to have a reading in a month for the month to tell a normal.
  static constexpr std::size_t least_years = 10;

  explicit CalendarNormals(std::size_t places);

  /// Takes the next step's readings, one for each place, NaN where it is silent, and the month in
  /// which the step lies, where its time tells one.
  void add(std::span<const double> readings, const std::optional<MonthOfYear>& when);

  std::size_t places() const { return places_; }
  /// The normals by place, as SeriesNormals has them.
  std::vector<double> of_year() const { return year_.result(); }
  std::vector<double> of_month(std::size_t month) const { return by_month_[month].result(); }
  /// How many places have a reading in each calendar month of enough years; none where the time of
  /// some step tells no month.
  std::size_t places_with_enough_years() const;

 private:
  std::size_t places_;
  SeriesNormals year_;
  std::vector<SeriesNormals> by_month_;
  // By month and year: the places that report.
  std::vector<std::map<int, std::vector<bool>>> reporting_;
  bool tells_months_ = true;
};

}  // namespace thiessen
