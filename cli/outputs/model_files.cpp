#include "cli/outputs/model_files.h"

#include <stdexcept>
#include <utility>

#include "files/basin_centroids.h"
#include "files/netcdf_series.h"
#include "results/models/hms_weights.h"
#include "results/models/hype_series.h"
#include "results/models/pi_xml_series.h"
#include "results/models/raven_weights.h"
#include "results/models/swat_series.h"
#include "results/models/swmm_series.h"

namespace thiessen::cli {

ModelFiles::ModelFiles(RainModel model, const std::string& path, Outputs& outputs,
                       const OutputRules& rules)
    : model_(model), path_(path), outputs_(outputs), rules_(rules) {
  switch (model) {
    case RainModel::netcdf:
      foreign_ = outputs.add_foreign(path);
      return;
    case RainModel::swat:
      outputs.make_folder(path);
      return;
    case RainModel::hype:
    case RainModel::swmm:
    case RainModel::pi_xml:
      file_ = &outputs.add(path);
  }
}

std::unique_ptr<ModelSeries> ModelFiles::series(const Inputs& inputs, ModelSubject subject,
                                                bool has_errors) {
  switch (model_) {
    case RainModel::netcdf: {
      std::vector<Point> plane;
      if (subject.centroids.empty()) plane = centroids_in_plane(inputs.study());
      return std::make_unique<NetcdfSeries>(foreign_, std::move(subject), std::move(plane),
                                            has_errors);
    }
    case RainModel::hype:
      return std::make_unique<HypeSeries>(*file_, std::move(subject));
    case RainModel::swat:
      return swat_series(std::move(subject));
    case RainModel::swmm:
      return std::make_unique<SwmmSeries>(*file_, std::move(subject));
    case RainModel::pi_xml:
      return std::make_unique<PiXmlSeries>(*file_, std::move(subject));
  }
  throw std::logic_error("not a model's format");
}

std::unique_ptr<ModelSeries> ModelFiles::swat_series(ModelSubject subject) {
  const std::vector<std::string> names = SwatSeries::files(subject.basins);
  auto series = std::make_unique<SwatSeries>(
      [this](const std::string& name) -> OutputFile& { return outputs_.add(path_ + '/' + name); },
      std::move(subject));
  // Whether the files may be written is known now, and not only when the series has been computed.
  for (const std::string& name : names) examine_destination(path_ + '/' + name, rules_);
  return series;
}

std::unique_ptr<const ModelWeights> weights_format(WeightsModel model) {
  switch (model) {
    case WeightsModel::hms:
      return std::make_unique<HmsWeights>();
    case WeightsModel::raven:
      return std::make_unique<RavenWeights>();
  }
  throw std::logic_error("not a model's format");
}

}  // namespace thiessen::cli
