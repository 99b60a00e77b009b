#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/outputs.h"
#include "cli/commands/commands.h"
#include "cli/inputs/fitted_normals_of.h"
#include "cli/inputs/gauges.h"
#include "cli/inputs/inputs.h"
#include "cli/options/blocks/common_options.h"
#include "cli/options/blocks/dual_options.h"
#include "cli/options/blocks/isohyet_options.h"
#include "cli/options/blocks/output_options.h"
#include "cli/options/blocks/rainfall_options.h"
#include "cli/options/blocks/study_options.h"
#include "cli/options/blocks/view_options.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"
#include "cli/outputs/cell_features.h"
#include "cli/outputs/dual_files.h"
#include "cli/outputs/encoded_files.h"
#include "cli/outputs/study_package_of.h"
#include "gdal/output/cells_layer.h"
#include "gdal/output/layer_formats.h"

namespace thiessen::cli {
namespace {

class CellsCommand : public Command {
 public:
  CellsCommand() {
    study_.declare(options(), Need::optional);
    rainfall_.declare(options(), Need::optional, study_.stations);
    rainfall_.declare_stamp(options());
    view_.declare_time(options());
    view_.declare_margin(options());
    isohyets_.declare_study(options());
    study_.declare_attributes(options());
    output_.declare(
        options(), Need::optional, "cells.geojson",
        "where the cells go; the extension tells the format, PG:... is a database; default GeoJSON "
        "on standard output");
    options().group("Output").add(
        "--study", flag(whole_study_),
        "the whole study in one .gpkg: layers cells, gauges, basins and, with --interval, "
        "isohyets, the table weights, and how QGIS shows them");
    output_.declare_table(options(), "cells");
    dual_.declare(options());
    common_.declare(options());
  }

  const char* name() const override { return "cells"; }
  const char* description() const override {
    return "Thiessen cells clipped to the basins: GeoJSON, or any vector format by extension";
  }
  const char* example() const override {
    return "samples/colorado/stations.csv samples/colorado/counties.geojson -o "
           "cells.geojson";
  }
  void check() const override {
    study_.check();
    rainfall_.check();
    view_.check(rainfall_.given(), study_.has_basins());
    output_.check();
    if (study_.attributes && !writes_cells()) {
      throw UsageError{"--attributes carries fields onto cells, and none are written",
                       "-o FILE writes cells beside --delaunay FILE and --neighbours FILE"};
    }
    dual_.check((writes_cells() || dual_.takes_place_of_cells()) && output_.output == "-");
    check_study();
  }

  void run(Warnings& warnings) override {
    Outputs outputs(output_.rules(rainfall_.files_beside(study_.files())));
    std::optional<DatabaseTable> table;
    if (output_.is_database() && writes_cells()) table.emplace(output_.table());
    OutputFile* const file = writes_cells() ? &opened(outputs, table) : nullptr;
    DualFiles dual(outputs, dual_, output_.output);
    const std::unique_ptr<GeoPackageCopy> older =
        file == nullptr ? nullptr : older_layers(output_.output);
    Inputs inputs(study_, view_.margin, common_.threads, warnings);
    fit_normals(inputs, study_, rainfall_, {.threads = common_.threads}, warnings);
    if (!rainfall_.given()) note_whole_network(inputs, warnings);
    const auto readings = shown_readings(inputs, study_, rainfall_, view_.time(), warnings);
    const GaugeReadings* shown = readings ? &*readings : nullptr;
    if (shown != nullptr) view_.units = unit_shown(shown->unit, view_.units, false, "");
    if (file != nullptr && !write_singly(outputs, *file, inputs, shown, warnings)) {
      CellsOutput output =
          cells_output(inputs, cells_of(inputs, shown, static_cast<unsigned>(common_.threads)),
                       shown, study_, view_.units);
      if (table) output.geometry_column = DatabaseTable::geometry_column;
      if (shown != nullptr && holds_colours(output_.output)) output.colours = colours_of(output);
      const std::string older_bytes = older ? older->bytes() : "";
      if (table) {
        cells_table(output, *table, warnings);
      } else if (whole_study_) {
        file->append(packaged(inputs, output, shown, older_bytes, warnings));
      } else if (output_.output == "-") {
        file->append(cells_geojson(output, "standard output", warnings));
      } else {
        append_files(outputs, *file, cells_files(output, output_.output, warnings, older_bytes));
      }
      warn_of_names(output, inputs, table ? table->name() : output_.output, warnings);
    }
    dual.write(inputs, study_, shown, view_.units, static_cast<unsigned>(common_.threads),
               warnings);
    outputs.commit();
  }
  bool quiet() const override { return common_.quiet; }

 private:
  void check_study() const {
    if (whole_study_ && (!writes_cells() || extension_of(output_.output) != "gpkg")) {
      throw UsageError{"--study writes one GeoPackage, and the output is none",
                       "-o study.gpkg names one"};
    }
    if (!isohyets_.has_interval()) return;
    if (!whole_study_)
      throw UsageError{"--interval is the step between isohyets of --study", "give --study too"};
    if (!rainfall_.given())
      throw UsageError{"--interval is about rainfall, and there is no RAINFALL", ""};
  }

  /// Cells are what the command is for; where other outputs are asked for and they are not, they
  /// are left out.
  bool writes_cells() const {
    return !dual_.takes_place_of_cells() && (output_.is_given() || !dual_.any());
  }
  OutputFile& opened(Outputs& outputs, std::optional<DatabaseTable>& table) const {
    if (table) return table->rows();
    if (output_.output != "-") require_cells_format(output_.output);
    return outputs.add(output_.output);
  }

  /// Writes cells as they come, without holding them. Returns false, with nothing written, where
  /// the output has to have them all at once.
  bool write_singly(Outputs& outputs, OutputFile& file, const Inputs& inputs,
                    const GaugeReadings* readings, Warnings& warnings) const {
    const bool is_stream = output_.output == "-";
    if (!is_stream && (output_.is_database() || !is_cells_geojson(output_.output))) return false;
    const CellsOutput output = cells_output(inputs, {}, readings, study_, view_.units);
    const auto threads = static_cast<unsigned>(common_.threads);
    if (!append_cells_geojson(file, output, cell_source(inputs, readings, threads))) return false;
    if (!is_stream) append_side_files(outputs, {{output_.output, {}}});
    warn_of_names(output, inputs, output_.output, warnings);
    return true;
  }

  static void warn_of_names(const CellsOutput& output, const Inputs& inputs,
                            const std::string& name, Warnings& warnings) {
    warn_of_new_names(output, name == "-" ? "standard output" : name, warnings);
    warn_of_own_coordinates(inputs, name, warnings);
  }

  std::string packaged(const Inputs& inputs, const CellsOutput& output,
                       const GaugeReadings* readings, const std::string& older,
                       Warnings& warnings) const {
    const auto threads = static_cast<unsigned>(common_.threads);
    PackageParts parts{.readings = readings,
                       .unit = readings == nullptr ? "" : view_.units,
                       .interval = isohyets_.interval,
                       .threads = threads};
    const std::vector<BasinWeights> weights = inputs.weighing().weights_in_month(
        readings == nullptr ? inputs.all_report() : readings->reports(), threads,
        readings == nullptr ? NormalMonth() : readings->month);
    parts.weights = &weights;
    if (readings != nullptr) parts.classes = classes_of(output);
    return study_package(study_package_of(inputs, output, parts), output_.output, older, warnings);
  }

  /// The classes that a picture of the same cells has.
  static RainfallClasses classes_of(const CellsOutput& output) {
    std::map<std::size_t, double> readings;  // by station, once each
    for (const CellFeature& cell : output.cells) readings[cell.attribute_row] = cell.rainfall;
    std::vector<double> values;
    values.reserve(readings.size());
    for (const auto& [station, rainfall] : readings) values.push_back(rainfall);
    return {std::move(values), {}};
  }
  static std::vector<Colour> colours_of(const CellsOutput& output) {
    const RainfallClasses classes = classes_of(output);
    std::vector<Colour> colours;
    for (const CellFeature& cell : output.cells) colours.push_back(classes.colour(cell.rainfall));
    return colours;
  }

  StudyOptions study_;
  RainfallOptions rainfall_;
  ViewOptions view_;
  IsohyetOptions isohyets_;
  bool whole_study_ = false;
  OutputOptions output_;
  DualOptions dual_;
  CommonOptions common_;
};

}  // namespace

std::unique_ptr<Command> make_cells_command() {
  return std::make_unique<CellsCommand>();
}

}  // namespace thiessen::cli
