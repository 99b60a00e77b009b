#include <string>
#include <utility>
#include <vector>

#include "base/outputs.h"
#include "cli/commands/commands.h"
#include "cli/inputs/fitted_normals_of.h"
#include "cli/inputs/gauges.h"
#include "cli/inputs/inputs.h"
#include "cli/options/blocks/common_options.h"
#include "cli/options/blocks/isohyet_options.h"
#include "cli/options/blocks/output_options.h"
#include "cli/options/blocks/period_options.h"
#include "cli/options/blocks/rainfall_options.h"
#include "cli/options/blocks/raster_options.h"
#include "cli/options/blocks/study_options.h"
#include "cli/options/blocks/view_options.h"
#include "cli/outputs/encoded_files.h"
#include "cli/outputs/maps_of.h"
#include "cli/outputs/provenance_of.h"
#include "cli/outputs/rasters/grid_steps.h"
#include "cli/outputs/rasters/raster_of.h"
#include "cli/outputs/rasters/raster_style.h"
#include "cli/outputs/rasters/surface_maps.h"
#include "cli/terminal/progress.h"
#include "files/netcdf_grid.h"
#include "files/rainfall/rainfall_file.h"
#include "gdal/output/image_file.h"
#include "gdal/rasters/geotiff_grid.h"
#include "gdal/rasters/raster_output.h"
#include "map/sheet/multiples.h"
#include "map/sheet/picture.h"
#include "rainfall/series/step_months.h"

namespace thiessen::cli {
namespace {

enum class Kind { png, jpeg, svg, tiff, netcdf };

bool is_picture(Kind kind) {
  return kind != Kind::tiff && kind != Kind::netcdf;
}

Kind kind_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  std::string extension = dot == std::string::npos ? "" : path.substr(dot + 1);
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (extension == "png") return Kind::png;
  if (extension == "jpg" || extension == "jpeg") return Kind::jpeg;
  if (extension == "svg") return Kind::svg;
  if (extension == "tif" || extension == "tiff") return Kind::tiff;
  if (extension == "nc") return Kind::netcdf;
  throw UsageError{"a map is a .png, .jpg, .svg, .tif or .nc, not '" + printable(path) + "'", ""};
}

PictureFormat format_of(Kind kind) {
  if (kind == Kind::svg) return PictureFormat::svg;
  return kind == Kind::jpeg ? PictureFormat::jpeg : PictureFormat::png;
}

class MapCommand : public Command {
 public:
  MapCommand() {
    study_.declare(options(), Need::optional);
    rainfall_.declare(options(), Need::optional, study_.stations);
    view_.declare_times(options());
    range_.declare_range(options());
    range_.declare_stamp(options(),
                         "which month's normals count, over which steps a total is spread "
                         "(--totals), and what bounds times have in a .nc (time_bnds)");
    rainfall_.times_are_of(range_);
    view_.declare_margin(options());
    surface_.declare_map(options());
    view_.declare_look(options());
    study_.declare_label(options());
    raster_.declare(options());
    output_.declare(options(), Need::required, "map.png", "where the picture or the raster goes");
    common_.declare(options());
  }

  const char* name() const override { return "map"; }
  const char* description() const override {
    return "a picture (.png, .jpg, .svg), or a georeferenced raster (.tif, .nc)";
  }
  const char* example() const override {
    return "samples/colorado/stations.csv samples/colorado/counties.geojson "
           "samples/colorado/rainfall.csv -o map.png";
  }
  void check() const override {
    const Kind kind = kind_of(output_.output);
    study_.check();
    rainfall_.check();
    view_.check(rainfall_.given(), study_.has_basins());
    range_.check();
    if (is_picture(kind)) {
      raster_.check_picture();
    } else {
      view_.check_raster(kind == Kind::netcdf);
      check_label();
    }
    check_times(kind);
    if (kind == Kind::netcdf) raster_.check_netcdf();
    check_steps();
    surface_.check_map(rainfall_.given(), is_picture(kind));
  }

  void run(Warnings& warnings) override {
    const Kind kind = kind_of(output_.output);
    if (is_picture(kind)) {
      check_picture_size(view_.width(), view_.height());
      check_picture_memory(view_.width(), view_.height(), format_of(kind));
    }
    Outputs outputs(output_.rules(rainfall_.files_beside(study_.files())));
    if (raster_.of_steps) return write_grid(kind, outputs, warnings);
    if (kind == Kind::tiff) return write_raster(outputs, warnings);
    OutputFile& file = outputs.add(output_.output);
    Inputs inputs(study_, view_.margin, common_.threads, warnings);
    fit_normals(inputs, study_, rainfall_, {.stamp = range_.stamp(), .threads = common_.threads},
                warnings);
    if (!rainfall_.given()) note_whole_network(inputs, warnings);
    const std::vector<GaugeReadings> steps = shown(inputs, warnings);
    if (!steps.empty()) settle_unit(steps.front().unit);
    const auto threads = static_cast<unsigned>(common_.threads);
    auto maps = maps_of(inputs, steps, study_, view_, threads);
    add_surfaces(inputs, steps, surface_, maps, threads);
    if (view_.title.empty() && surface_.shows_any()) maps.front().title = title_of(surface_);
    file.append(encode_multiples(maps, format_of(kind), image_file, warnings));
    outputs.commit();
  }
  bool quiet() const override { return common_.quiet; }

 private:
  /// Where a raster goes: to a name in a hidden folder, or into an open pipe or device.
  struct RasterPlace {
    std::string file_on_disk{};
    OutputFile* stream = nullptr;
  };
  RasterPlace raster_place(Outputs& outputs) const {
    if (outputs.is_stream(output_.output)) return {.stream = &outputs.add(output_.output)};
    return {.file_on_disk = outputs.add_foreign(output_.output)};
  }
  static void add_raster(Outputs& outputs, const RasterPlace& place,
                         const std::vector<EncodedFile>& files) {
    if (place.stream != nullptr) return append_files(outputs, *place.stream, files);
    append_side_files(outputs, files);
  }

  void write_raster(Outputs& outputs, Warnings& warnings) {
    const RasterPlace place = raster_place(outputs);
    Inputs inputs(study_, view_.margin, common_.threads, warnings);
    fit_normals(inputs, study_, rainfall_, {.stamp = range_.stamp(), .threads = common_.threads},
                warnings);
    if (!rainfall_.given()) note_whole_network(inputs, warnings);
    const std::vector<GaugeReadings> steps = shown(inputs, warnings);
    if (!steps.empty()) settle_unit(steps.front().unit);
    const GaugeReadings* const step = steps.empty() ? nullptr : &steps.front();
    const ShownRaster raster{step, view_.time(), surface_.surface(), view_.colours.rule};
    RasterOutput output = raster_output(inputs, step);
    output.file_on_disk = place.file_on_disk;
    add_raster(outputs, place, raster_of(inputs, raster, output, warnings));
    outputs.commit();
  }

  /// The readings of each map: the steps that were asked for, or the means; none without RAINFALL.
  std::vector<GaugeReadings> shown(Inputs& inputs, Warnings& warnings) const {
    if (!view_.times.empty()) return shown_steps(inputs, study_, rainfall_, view_.times, warnings);
    auto means = shown_readings(inputs, study_, rainfall_, "", warnings);
    if (!means) return {};
    return {*std::move(means)};
  }

  void check_times(Kind kind) const {
    if (is_picture(kind) || raster_.of_steps || view_.times.size() < 2) return;
    throw UsageError{"several maps stand on a picture's page, and a raster is of one --time",
                     "--steps writes a grid of steps; --from and --to choose some"};
  }

  void check_label() const {
    const Option* const label = study_.label_option();
    if (label == nullptr) return;
    throw UsageError{label->name + " is about pictures, and a raster is written", "leave it out"};
  }

  void check_steps() const {
    if (!raster_.of_steps) {
      const Option* const given = range_.first_given();
      const bool is_of_totals = given == range_.stamp_option() && rainfall_.totals().given();
      if (given == nullptr || is_of_totals) return;
      throw UsageError{given->name + " chooses time steps, and one raster or picture is written",
                       "--steps writes a grid of them; --time shows one"};
    }
    if (!rainfall_.given()) throw UsageError{"--steps needs RAINFALL", ""};
    const bool stamp_acts = kind_of(output_.output) == Kind::netcdf || study_.has_normals() ||
                            rainfall_.totals().given();
    if (range_.stamp_option() != nullptr && !stamp_acts) {
      throw UsageError{"--stamp is about bounds of times, which a .nc has",
                       "write a .nc, or leave it out"};
    }
    if (!view_.times.empty()) {
      throw UsageError{"--time shows one step, and --steps writes all",
                       "--from and --to choose some; leave one of the two out"};
    }
    if (rainfall_.is_standard_input()) {
      throw UsageError{"--steps reads RAINFALL twice, and standard input can be read once",
                       "give a file"};
    }
  }

  void settle_unit(const std::string& known) {
    view_.units = unit_shown(known, view_.units, view_.are_units_given(), rainfall_.name());
  }

  void write_grid(Kind kind, Outputs& outputs, Warnings& warnings) {
    if (!can_be_read_again(rainfall_.request({}))) {
      throw UsageError{
          "--steps reads RAINFALL twice, and " + printable(rainfall_.name()) + " is not a file",
          ""};
    }
    const RasterPlace place = kind == Kind::netcdf
                                  ? RasterPlace{.file_on_disk = outputs.add_foreign(output_.output)}
                                  : raster_place(outputs);
    Inputs inputs(study_, view_.margin, common_.threads, warnings);
    fit_normals(inputs, study_, rainfall_, {.stamp = range_.stamp(), .threads = common_.threads},
                warnings);
    Warnings told_later;
    const auto first = inputs.open_readings(study_, rainfall_, told_later, range_.times());
    settle_unit(first->unit());
    range_.settle_stamp(first->stamp(), rainfall_.name());
    GridSteps steps = look_through(*first, inputs.network(), rainfall_.name());
    RasterOutput output = raster_output(inputs, nullptr);
    output.file_on_disk = place.file_on_disk;
    if (kind == Kind::netcdf) {
      NetcdfGrid grid(
          output.file_on_disk, output,
          times_of(steps, length_of(inputs, steps), range_.stamp(), rainfall_.name(), warnings));
      fill_grid(inputs, steps, output, grid, warnings);
      grid.close();
      remove_side_files(outputs, output_.output);
    } else {
      GeoTiffGrid grid(output, steps.times);
      fill_grid(inputs, steps, output, grid, warnings);
      const std::vector<double> values = steps.sample.values();
      const RainfallClasses classes(values, view_.colours.rule);
      warn_of_outside(classes, false, warnings);
      const RainfallStyle style(classes, values, output.made_by.unit);
      grid.set_classes(style.classes());
      std::vector<EncodedFile> files = grid.finish();
      files.push_back(style.file(output.path));
      add_raster(outputs, place, files);
    }
    outputs.commit();
  }

  /// The series' own step, for which all of RAINFALL is read where the steps that are written do
  /// not tell it.
  std::optional<StepLength> length_of(Inputs& inputs, const GridSteps& steps) const {
    const auto step = step_of(steps);
    if (step || range_.first_given() == nullptr) return step;
    Warnings told_elsewhere;
    return step_of(*inputs.open_readings(study_, rainfall_, told_elsewhere));
  }

  /// Writes all steps. Of a surface it is its values, not the readings, that the sample is of.
  void fill_grid(Inputs& inputs, GridSteps& steps, const RasterOutput& output, GridFile& grid,
                 Warnings& warnings) const {
    const auto readings = inputs.open_readings(study_, rainfall_, warnings, range_.times());
    Progress progress("time step", common_.quiet,
                      [&](std::size_t done) { return readings->share_of(done); });
    const auto advance = [&] { progress.advance(); };
    const StepMonths months(rainfall_.name(), range_.stamp());
    const NormalField* const normals = inputs.weighing().normals();
    const auto month_of = [&](const TimeStep& step) -> NormalMonth {
      if (normals == nullptr || normals->months() == 1) return {};
      return months.of(step.time, step.written, step.line);
    };
    if (!surface_.surface()) {
      return write_steps(inputs, steps, *readings, output.grid, output.threads, grid, month_of,
                         advance);
    }
    steps.sample = {};
    write_surfaces(inputs, *surface_.surface(), *readings, output.grid, output.threads, grid,
                   steps.sample, month_of, advance);
  }

  RasterOutput raster_output(const Inputs& inputs, const GaugeReadings* shown) const {
    RasterOutput output;
    output.grid = raster_grid(inputs, raster_.resolution);
    output.crs = inputs.study().output_crs();
    output.made_by = provenance_of(inputs, study_, shown, view_.units);
    if (surface_.surface()) output.made_by.method = name_of(*surface_.surface());
    if (raster_.of_steps) output.made_by.unit = view_.units;
    output.path = output_.output;
    output.compression = raster_.compression;
    output.has_overviews = raster_.has_overviews;
    output.threads = static_cast<unsigned>(common_.threads);
    return output;
  }

  StudyOptions study_;
  RainfallOptions rainfall_;
  PeriodOptions range_;
  IsohyetOptions surface_;
  ViewOptions view_;
  RasterOptions raster_;
  OutputOptions output_;
  CommonOptions common_;
};

}  // namespace

std::unique_ptr<Command> make_map_command() {
  return std::make_unique<MapCommand>();
}

}  // namespace thiessen::cli
