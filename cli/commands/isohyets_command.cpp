#include <memory>
#include <string>
#include <vector>

#include "base/outputs.h"
#include "base/utf8.h"
#include "cli/commands/commands.h"
#include "cli/inputs/fitted_normals_of.h"
#include "cli/inputs/gauges.h"
#include "cli/inputs/inputs.h"
#include "cli/options/blocks/common_options.h"
#include "cli/options/blocks/isohyet_options.h"
#include "cli/options/blocks/output_options.h"
#include "cli/options/blocks/rainfall_options.h"
#include "cli/options/blocks/study_options.h"
#include "cli/options/blocks/view_options.h"
#include "cli/options/option_values.h"
#include "cli/outputs/encoded_files.h"
#include "cli/outputs/provenance_of.h"
#include "cli/outputs/rasters/isohyets_in.h"
#include "cli/outputs/rasters/raster_of.h"
#include "cli/outputs/rasters/surface_maps.h"
#include "gdal/output/isohyets_file.h"
#include "gdal/output/layer_formats.h"
#include "geometry/polygon.h"

namespace thiessen::cli {
namespace {

class IsohyetsCommand : public Command {
 public:
  IsohyetsCommand() {
    study_.declare(options(), Need::required);
    rainfall_.declare(options(), Need::required, study_.stations);
    rainfall_.declare_stamp(options());
    view_.declare_time(options());
    isohyets_.declare(options());
    OptionGroup method = options().group("Method");
    method.add("--resolution", number(resolution_, above_zero),
               "the pixel of the raster on which lines are drawn, in units of the basins' CRS; "
               "default: the longer side in 1000 pixels, or as behind a picture where its classes "
               "are the levels");
    units_option_ = &options()
                         .group("Readings")
                         .add("--units", any_text(units_, "U"),
                              "what the readings are in where nothing else says it; default mm");
    output_.declare(options(), Need::optional, "lines.geojson",
                    "where the lines go; the extension tells the format; default GeoJSON on "
                    "standard output");
    common_.declare(options());
  }

  const char* name() const override { return "isohyets"; }
  const char* description() const override {
    return "lines of equal rainfall: GeoJSON, or any vector format by extension";
  }
  const char* example() const override {
    return "samples/colorado/stations.csv samples/colorado/counties.geojson "
           "samples/colorado/rainfall.csv --time 1990-04 -o lines.geojson";
  }
  void check() const override {
    study_.check();
    rainfall_.check();
    isohyets_.check();
  }

  void run(Warnings& warnings) override {
    Outputs outputs(output_.rules(rainfall_.files_beside(study_.files())));
    const std::string path = output_.output == "-" ? "isohyets.geojson" : output_.output;
    require_vector_driver(path);
    OutputFile& file = outputs.add(output_.output);
    const std::unique_ptr<GeoPackageCopy> older = older_layers(output_.output);
    Inputs inputs(study_, 0, common_.threads, warnings);
    fit_normals(inputs, study_, rainfall_, {.threads = common_.threads}, warnings);
    const auto readings = shown_readings(inputs, study_, rainfall_, view_.time(), warnings);
    units_ = unit_shown(readings->unit, units_, units_option_->is_given(), rainfall_.name());
    const auto isohyets = isohyets_of(inputs, *readings);
    if (isohyets.empty()) {
      warnings.add_notice({output_.output == "-" ? "standard output" : path, 0,
                           "no isohyet crosses a basin, and the file has none", ""});
    }
    std::vector<std::string> ids;
    for (const Basin& basin : inputs.basins()) ids.push_back(basin.id);
    Provenance made_by = provenance_of(inputs, study_, &*readings, units_);
    made_by.method = name_of(*isohyets_.surface());
    const auto files = isohyets_file(isohyets, ids, inputs.study().output_crs(), made_by, path,
                                     older ? older->bytes() : "", warnings);
    if (output_.output == "-") {
      file.append(files.front().bytes);
    } else {
      append_files(outputs, file, files);
    }
    outputs.commit();
  }
  bool quiet() const override { return common_.quiet; }

 private:
  std::vector<Isohyet> isohyets_of(const Inputs& inputs, const GaugeReadings& readings) const {
    if (!readings.reports().any()) return {};
    const auto threads = static_cast<unsigned>(common_.threads);
    const std::vector<MultiPolygon> areas = areas_of(inputs);
    const IsohyetLevels levels{isohyets_.interval, isohyets_.breaks};
    if (levels.interval == 0 && levels.levels.empty())
      return pictured_isohyets(inputs, readings, isohyets_.drawn(), resolution_, areas, threads);
    return isohyets_in(inputs, readings, isohyets_.drawn(), {.resolution = resolution_}, levels,
                       areas, threads);
  }

  StudyOptions study_;
  RainfallOptions rainfall_;
  ViewOptions view_;
  IsohyetOptions isohyets_;
  double resolution_ = 0;
  std::string units_ = "mm";
  const Option* units_option_ = nullptr;
  OutputOptions output_;
  CommonOptions common_;
};

}  // namespace

std::unique_ptr<Command> make_isohyets_command() {
  return std::make_unique<IsohyetsCommand>();
}

}  // namespace thiessen::cli
