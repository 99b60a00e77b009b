#include "gdal/output/study_layers.h"

#include <ogr_geometry.h>

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "gdal/layers/geometry_conversion.h"
#include "gdal/output/isohyets_file.h"
#include "gdal/output/vector_layer.h"
#include "outlines/antimeridian.h"

namespace thiessen {
namespace {

/// A layer whose fields are given one by one: its texts first, then its numbers.
class LayerBuilder {
 public:
  using Text = std::function<std::string(std::size_t row)>;
  using Number = std::function<std::optional<double>(std::size_t row)>;

  LayerBuilder(std::string name, VectorLayer::Shapes shapes, std::size_t rows) {
    layer_.name = std::move(name);
    layer_.shapes = shapes;
    layer_.values.rows = rows;
  }
  void add(const std::string& name, Text text) {
    add_field(name, FieldType::text);
    texts_.push_back(std::move(text));
    numbers_.emplace_back();
  }
  void add(const std::string& name, FieldType type, Number number) {
    add_field(name, type);
    texts_.emplace_back();
    numbers_.push_back(std::move(number));
  }
  VectorLayer finish(std::function<std::unique_ptr<OGRGeometry>(std::size_t)> shape,
                     const std::optional<Provenance>& made_by) {
    layer_.own_fields = layer_.fields.size();
    layer_.values.text = [this](std::size_t row, std::size_t field) {
      if (texts_[field]) return texts_[field](row);
      if (layer_.fields[field].type == FieldType::real) return std::string();
      return std::to_string(static_cast<long long>(numbers_[field](row).value_or(0)));
    };
    layer_.values.number = [this](std::size_t row, std::size_t field) {
      return numbers_[field] ? numbers_[field](row) : std::nullopt;
    };
    layer_.shape = std::move(shape);
    layer_.made_by = made_by;
    return layer_;
  }

 private:
  void add_field(const std::string& name, FieldType type) {
    layer_.fields.push_back({name, type});
    layer_.values.names.push_back(name);
  }

  VectorLayer layer_;
  std::vector<Text> texts_;
  std::vector<Number> numbers_;
};

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::unique_ptr<OGRGeometry> no_shape(std::size_t /*row*/) {
  return nullptr;
}

/// Adds one layer after the other to a GeoPackage.
class LayersWriter {
 public:
  LayersWriter(const StudyLayers& layers, const std::string& path, std::string bytes,
               Warnings& warnings)
      : layers_(layers), path_(path), warnings_(warnings), bytes_(std::move(bytes)) {}

  std::string write() {
    add_gauges();
    add_basins();
    if (layers_.isohyets) {
      const std::vector<std::string> ids = basin_ids();
      bytes_ = isohyets_file(*layers_.isohyets, ids, layers_.crs, *layers_.made_by, path_, bytes_,
                             warnings_)
                   .front()
                   .bytes;
    }
    add_weights();
    if (layers_.rain) add_rain(*layers_.rain);
    return with_layer_styles(bytes_, layers_.styles, path_);
  }

 private:
  std::vector<std::string> basin_ids() const {
    std::vector<std::string> ids;
    for (const BasinSummary& basin : layers_.basins) ids.push_back(basin.basin);
    return ids;
  }

  void add(const VectorLayer& layer) {
    bytes_ = write_vector_layer(layer, layers_.crs, path_, bytes_, warnings_).front().bytes;
  }

  void add_gauges() {
    LayerBuilder layer("gauges", VectorLayer::Shapes::points, layers_.gauges.size());
    layer.add("station", [&](std::size_t row) { return layers_.gauges[row].station; });
    if (layers_.has_rainfall) {
      layer.add("rainfall", FieldType::real,
                [&](std::size_t row) { return finite(layers_.gauges[row].rainfall); });
    }
    add(layer.finish(
        [&](std::size_t row) {
          const Point at = layers_.gauges[row].position;
          return std::make_unique<OGRPoint>(at.x, at.y);
        },
        layers_.made_by));
  }

  void add_basins() {
    const std::vector<BasinSummary>& basins = layers_.basins;
    LayerBuilder layer("basins", VectorLayer::Shapes::polygons, basins.size());
    layer.add("basin", [&](std::size_t row) { return basins[row].basin; });
    layer.add(layers_.area_column, FieldType::real,
              [&](std::size_t row) { return std::optional(basins[row].area); });
    if (layers_.has_series) add_series_fields(layer);
    add(layer.finish([&](std::size_t row) { return ogr_shape(basin_shape(row)); },
                     layers_.made_by));
  }

  /// The shape of a basin; of degrees each longitude lies in [-180, 180].
  MultiPolygon basin_shape(std::size_t basin) const {
    CurvedShape shape{layers_.basin_shapes[basin], {}};
    if (layers_.crs && layers_.crs->degrees_per_unit() == 1) cut_at_antimeridian(shape);
    return std::move(shape.shape);
  }

  void add_series_fields(LayerBuilder& layer) const {
    const std::vector<BasinSummary>& basins = layers_.basins;
    const auto count = [](std::size_t number) {
      return std::optional(static_cast<double>(number));
    };
    layer.add("gauges_inside", FieldType::integer,
              [=](std::size_t row) { return count(basins[row].gauges_inside); });
    layer.add("gauges_weighing", FieldType::integer,
              [=](std::size_t row) { return count(basins[row].gauges_weighing); });
    layer.add("largest_weight", FieldType::real,
              [&](std::size_t row) { return std::optional(basins[row].largest_weight); });
    layer.add("mean", FieldType::real, [&](std::size_t row) { return basins[row].mean; });
    layer.add("standard_error", FieldType::real,
              [&](std::size_t row) { return basins[row].standard_error; });
    layer.add("largest", FieldType::real, [&](std::size_t row) { return basins[row].largest; });
    layer.add("empty_steps", FieldType::integer,
              [=](std::size_t row) { return count(basins[row].empty_steps); });
    for (std::size_t i = 0; !basins.empty() && i < basins.front().depths.size(); ++i) {
      const std::string name = "max_" + basins.front().depths[i].length;
      layer.add(name, FieldType::real,
                [&basins, i](std::size_t row) { return basins[row].depths[i].depth; });
      layer.add(name + "_time",
                [&basins, i](std::size_t row) { return basins[row].depths[i].time; });
    }
  }

  void add_weights() {
    const std::vector<WeightRow>& weights = layers_.weights;
    LayerBuilder layer("weights", VectorLayer::Shapes::none, weights.size());
    layer.add("basin", [&](std::size_t row) { return weights[row].basin; });
    layer.add("station", [&](std::size_t row) { return weights[row].station; });
    layer.add(layers_.area_column, FieldType::real,
              [&](std::size_t row) { return std::optional(weights[row].area); });
    layer.add("weight", FieldType::real,
              [&](std::size_t row) { return std::optional(weights[row].weight); });
    if (layers_.has_factors) {
      layer.add("factor", FieldType::real,
                [&](std::size_t row) { return std::optional(weights[row].factor); });
    }
    add(layer.finish(no_shape, of_series()));
  }

  /// How tables were made that are not of the readings which the cells show.
  std::optional<Provenance> of_series() const {
    std::optional<Provenance> made_by = layers_.made_by;
    if (made_by) made_by->rainfall.clear();
    return made_by;
  }

  void add_rain(const StudyLayers::Rain& rain) {
    const std::size_t basins = layers_.basins.size();
    LayerBuilder layer("rain", VectorLayer::Shapes::none, rain.values.size());
    layer.add("time", [&](std::size_t row) { return rain.times[row / basins]; });
    layer.add("basin", [&](std::size_t row) { return layers_.basins[row % basins].basin; });
    layer.add("rainfall", FieldType::real,
              [&](std::size_t row) { return finite(rain.values[row]); });
    add(layer.finish(no_shape, of_series()));
  }

  const StudyLayers& layers_;
  const std::string& path_;
  Warnings& warnings_;
  std::string bytes_;
};

}  // namespace

std::string with_study_layers(std::string geopackage, const StudyLayers& layers,
                              const std::string& path, Warnings& warnings) {
  return LayersWriter(layers, path, std::move(geopackage), warnings).write();
}

}  // namespace thiessen
