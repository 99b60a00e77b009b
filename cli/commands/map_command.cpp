#include <string>

#include "base/outputs.h"
#include "cli/commands/commands.h"
#include "cli/inputs/gauges.h"
#include "cli/inputs/inputs.h"
#include "cli/options/common_options.h"
#include "cli/options/output_options.h"
#include "cli/options/rainfall_options.h"
#include "cli/options/raster_options.h"
#include "cli/options/study_options.h"
#include "cli/options/view_options.h"
#include "cli/outputs/cell_features.h"
#include "cli/outputs/encoded_files.h"
#include "cli/outputs/picture_of.h"
#include "cli/outputs/provenance_of.h"
#include "cli/outputs/raster_of.h"
#include "gdal/output/raster_output.h"

namespace thiessen::cli {
namespace {

enum class Kind { png, jpeg, svg, tiff };

Kind kind_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  std::string extension = dot == std::string::npos ? "" : path.substr(dot + 1);
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (extension == "png") return Kind::png;
  if (extension == "jpg" || extension == "jpeg") return Kind::jpeg;
  if (extension == "svg") return Kind::svg;
  if (extension == "tif" || extension == "tiff") return Kind::tiff;
  throw UsageError{"a map is a .png, .jpg, .svg or .tif, not '" + printable(path) + "'", ""};
}

PictureFormat format_of(Kind kind) {
  if (kind == Kind::svg) return PictureFormat::svg;
  return kind == Kind::jpeg ? PictureFormat::jpeg : PictureFormat::png;
}

class MapCommand : public Command {
 public:
  MapCommand() {
    study_.declare(options(), Need::optional);
    rainfall_.declare(options(), Need::optional);
    view_.declare_time(options());
    view_.declare_margin(options());
    view_.declare_look(options());
    study_.declare_label(options());
    raster_.declare(options());
    output_.declare(options(), Need::required, "map.png", "where the picture or the raster goes");
    common_.declare(options());
  }

  const char* name() const override { return "map"; }
  const char* description() const override {
    return "a picture (.png, .jpg, .svg), or a georeferenced raster (.tif)";
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
    if (kind == Kind::tiff) {
      view_.check_raster();
      if (const Option* label = study_.label_option())
        throw UsageError{label->name + " is about pictures, and a .tif is a raster",
                         "leave it out"};
    } else {
      raster_.check_picture();
    }
  }

  void run(Warnings& warnings) override {
    const Kind kind = kind_of(output_.output);
    if (kind != Kind::tiff) {
      check_picture_size(view_.width(), view_.height());
    }
    Outputs outputs(output_.rules({study_.stations, study_.basins, rainfall_.rainfall}));
    OutputFile& file = outputs.add(output_.output);
    Inputs inputs(study_, view_.margin, common_.threads, warnings);
    if (!rainfall_.given()) note_whole_network(inputs, warnings);
    const auto readings = shown_readings(inputs, study_, rainfall_, view_.time, warnings);
    const GaugeReadings* shown = readings ? &*readings : nullptr;
    const unsigned threads = static_cast<unsigned>(common_.threads);
    if (kind == Kind::tiff) {
      append_files(outputs, file,
                   raster_of(inputs, shown, view_.time, raster_output(inputs, shown)));
    } else {
      const auto cells = cells_of(inputs, shown, threads);
      file.append(encode_picture(picture_of(inputs, cells, shown, study_, view_), format_of(kind),
                                 warnings));
    }
    outputs.commit();
  }
  bool quiet() const override { return common_.quiet; }

 private:
  RasterOutput raster_output(const Inputs& inputs, const GaugeReadings* shown) const {
    RasterOutput output;
    output.grid = raster_grid(inputs, raster_.resolution);
    output.crs = inputs.study().output_crs();
    output.made_by = provenance_of(inputs, study_, shown, view_.units);
    output.path = output_.output;
    output.compression = raster_.compression;
    output.has_overviews = raster_.has_overviews;
    output.threads = static_cast<unsigned>(common_.threads);
    return output;
  }

  StudyOptions study_;
  RainfallOptions rainfall_;
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
