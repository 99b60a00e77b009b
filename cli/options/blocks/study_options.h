#pragma once

#include <string>
#include <vector>

#include "cli/options/blocks/csv_options.h"
#include "cli/options/option_list.h"
#include "files/study_files.h"

namespace thiessen::cli {

/// The arguments STATIONS and BASINS, and the options that say how to read them.
class StudyOptions : public OptionBlock {
 public:
  std::string stations;
  std::string basins;
  bool attributes = false;
  /// The gauges that a what-if opens and STATIONS lacks, in its coordinates.
  std::vector<Point> opened;

  void declare(OptionList& options, Need basins_need);
  void declare_attributes(OptionList& options);
  void declare_label(OptionList& options);
  /// Throws UsageError for options that contradict each other.
  void check() const;
  /// The request to read the study as the options say. Throws Error where the name of a CRS is
  /// empty.
  StudyRequest request() const;
  bool has_basins() const { return basins_option_->is_given(); }
  /// What is said of how all CSV files are written.
  const CsvDialect& csv() const { return csv_.said(); }
  double tolerance() const { return tolerance_; }
  /// The raster of normals, where has_normal_raster().
  const std::string& normals() const { return normals_; }
  bool has_normal_raster() const { return normals_option_->is_given(); }
  /// The field of normals of stations and basins; empty where none is given.
  const std::string& normal_field() const { return normal_field_; }
  /// The raster of the ground's elevations, by which normals are fitted; empty where none is given.
  const std::string& elevation() const { return elevation_; }
  /// The field of elevations; empty where none is named.
  const std::string& elevation_field() const { return elevation_field_; }
  /// Whether normals are to be fitted to RAINFALL by elevation.
  bool fits_normals() const { return elevation_option_->is_given() || !elevation_field_.empty(); }
  bool has_normals() const {
    return has_normal_raster() || !normal_field_.empty() || fits_normals();
  }
  /// The files that are read.
  std::vector<std::string> files() const;
  bool allow_far() const { return allow_far_; }
  /// Whether pictures name the stations.
  bool labels() const { return label_ != "none"; }
  /// The option that says how pictures name the stations; nullptr where it is not given.
  const Option* label_option() const {
    return label_option_ != nullptr && label_option_->is_given() ? label_option_ : nullptr;
  }

 private:
  void declare_fields(OptionGroup group);
  void declare_layers(OptionGroup group);
  void declare_method(OptionGroup group);
  void declare_normals(OptionGroup group);
  void declare_elevations(OptionGroup group);
  void check_normals() const;
  void check_texts() const;

  std::string id_, x_, y_, basin_id_, label_;
  std::string normals_, normal_field_, elevation_, elevation_field_;
  std::string crs_, basins_crs_, plane_, metric_;
  std::string stations_layer_, basins_layer_, stations_where_, basins_where_;
  double tolerance_ = 0.1;
  CsvOptionsOf csv_, stations_csv_, basins_csv_;
  bool mend_ = false;
  bool skip_unplaced_ = false;
  bool allow_far_ = false;
  const Option* basins_option_ = nullptr;
  const Option* plane_option_ = nullptr;
  const Option* label_option_ = nullptr;
  const Option* mend_option_ = nullptr;
  const Option* normals_option_ = nullptr;
  const Option* normal_field_option_ = nullptr;
  const Option* elevation_option_ = nullptr;
  const Option* elevation_field_option_ = nullptr;
  std::vector<const Option*> crs_options_;
  std::vector<const Option*> of_basins_;  ///< options that are about BASINS alone
};

}  // namespace thiessen::cli
