#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/destination.h"
#include "cli/options/option_values.h"
#include "files/study_files.h"
#include "rainfall/series/dated_readings.h"
#include "rainfall/series/rain_periods.h"
#include "rainfall/weighed_rainfall.h"
#include "readings/readings_reader.h"
#include "results/rain_file.h"

namespace thiessen::cli {

enum class Need { required, optional };

/// STATIONS, BASINS and what says how to read them.
struct StudyOptions {
  std::string stations;
  std::string basins;
  bool attributes = false;
  std::vector<Point> opened;  ///< gauges that STATIONS lacks, in its coordinates

  void add_to(CLI::App& app, Need basins_need);
  void add_attributes_to(CLI::App& app);
  /// Throws UsageError for options that contradict each other.
  StudyRequest request() const;
  char separator() const { return separator_; }
  bool decimal_comma() const { return decimal_comma_; }
  double tolerance() const { return tolerance_; }

 private:
  std::string id_, x_, y_, basin_id_;
  std::string crs_, basins_crs_, plane_, metric_;
  std::string stations_layer_, basins_layer_, stations_where_, basins_where_;
  double tolerance_ = 0.1;
  char separator_ = '\0';
  bool decimal_comma_ = false;

  void check_texts() const;
  CLI::App* app_ = nullptr;
};

/// RAINFALL and what says how to read it.
struct RainfallOptions {
  std::string rainfall;

  void add_to(CLI::App& app, Need need);
  /// RAINFALL as the value of an option.
  void add_as_option_to(CLI::App& app, const std::string& name, const std::string& help);
  /// `decimal_comma` is an option of the study.
  ReadingsOptions readings(bool decimal_comma) const;
  bool given() const { return !rainfall.empty(); }
  /// For messages.
  std::string name() const { return rainfall == "-" ? "standard input" : rainfall; }

 private:
  void add_meaning_to(CLI::App& app);

  ReadingsOptions readings_;
};

/// How steps with silent gauges are treated.
struct GapOptions {
  void add_to(CLI::App& app);
  /// Only how much may be remembered.
  void add_cache_to(CLI::App& app);
  ArealRainfallSettings settings() const {
    ArealRainfallSettings settings = settings_;
    settings.remembered_bytes = cache_ << 20U;
    return settings;
  }

 private:
  ArealRainfallSettings settings_;
  std::size_t cache_ = 256;  // MB
};

/// What areal rainfall is computed by.
enum class RainMethod { thiessen, arithmetic, idw, natural };

struct MethodOptions {
  void add_to(CLI::App& app);
  /// One, or several in the order of their columns. Throws UsageError for options that contradict
  /// each other.
  const std::vector<RainMethod>& methods() const;
  /// In a basin.
  std::size_t points() const { return points_; }

 private:
  std::vector<RainMethod> methods_{RainMethod::thiessen};
  std::size_t points_ = 2000;
  CLI::App* app_ = nullptr;
};

/// How rain.csv looks.
struct RainFormatOptions {
  void add_to(CLI::App& app);
  RainFormat format() const { return {long_, static_cast<int>(decimals_)}; }

 private:
  bool long_ = false;
  std::size_t decimals_ = 3;
};

/// Which steps count, and what they are summed over.
struct PeriodOptions {
  void add_to(CLI::App& app);
  /// Only which steps count.
  void add_range_to(CLI::App& app);
  /// What that asks of the times, if anything. Throws UsageError for options that contradict each
  /// other.
  std::optional<StepTimes> times() const;
  /// None: the steps themselves are wanted.
  std::optional<Totalling> totalling() const;

 private:
  std::string text_of(const char* option) const;

  TimeRange range_;
  std::optional<TimePrecision> every_;
  std::size_t allowed_missing_ = 0;
  CLI::App* app_ = nullptr;
};

/// Which step a picture or the cells show, and how a picture looks.
struct ViewOptions {
  std::string time;
  double margin = 10;
  std::string units = "mm";
  std::string title;
  PixelSize size;

  void add_time_to(CLI::App& app);
  void add_margin_to(CLI::App& app);
  void add_look_to(CLI::App& app);
};

/// Where results go.
struct OutputOptions {
  std::string output = "-";

  void add_to(CLI::App& app, Need need, const std::string& kind, const std::string& help);
  /// `inputs` are files that may not be written.
  OutputRules rules(std::vector<std::string> inputs) const {
    return {overwrite_, std::move(inputs)};
  }

 private:
  bool overwrite_ = false;
};

/// Options of every command.
struct CommonOptions {
  std::size_t threads;
  bool quiet = false;

  CommonOptions();
  void add_to(CLI::App& app);
};

}  // namespace thiessen::cli
