#pragma once

#include <optional>
#include <vector>

#include "cli/options/option_list.h"
#include "rainfall/methods/rain_surface.h"

namespace thiessen::cli {

/// The options that say which surface is shown, and at which levels isohyets are drawn.
class IsohyetOptions : public OptionBlock {
 public:
  double interval = 0;         ///< 0: the bounds of the picture's classes
  std::vector<double> breaks;  ///< the levels themselves, where they are given
  bool on_map = false;         ///< whether a picture has isohyets

  /// Declares --method for a map, whose default are Thiessen's cells, and isohyets over it. Their
  /// levels are those of the map's classes, or multiples of an interval.
  void declare_map(OptionList& options);
  /// Declares --method for isohyets, and their levels.
  void declare(OptionList& options);
  /// Declares --interval for a study in one file, which has isohyets of natural neighbours where it
  /// is given.
  void declare_study(OptionList& options);
  bool has_interval() const { return interval_option_ != nullptr && interval_option_->is_given(); }
  /// Throws UsageError for Thiessen's cells, which have no isohyets, and for levels that are given
  /// in two ways.
  void check() const;
  /// The surface; nothing for Thiessen's cells.
  const std::optional<SurfaceMethod>& surface() const { return surface_; }
  /// Whether a map shows a surface or isohyets.
  bool shows_any() const { return surface_.has_value() || on_map; }
  /// The surface whose isohyets are drawn: that which is shown, else natural neighbours.
  SurfaceMethod drawn() const { return surface_.value_or(SurfaceMethod::natural); }
  /// Throws UsageError for options of isohyets where a map has none, or where it shows no rainfall
  /// or is a raster.
  void check_map(bool has_rainfall, bool is_picture) const;

 private:
  std::optional<SurfaceMethod> surface_;
  const Option* method_option_ = nullptr;
  const Option* isohyets_option_ = nullptr;
  const Option* interval_option_ = nullptr;
  const Option* breaks_option_ = nullptr;
};

}  // namespace thiessen::cli
