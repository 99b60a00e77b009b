#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/default_arithmetic.h"
#include "base/interrupt.h"
#include "base/secrets.h"
#include "base/version.h"
#include "cli/options/usage_error.h"
#include "python/places.h"
#include "python/python_study.h"
#include "python/waiting.h"

namespace py = pybind11;

namespace thiessen::python {
namespace {

/// Of a function that computes, or reads numbers: see DefaultArithmetic.
using computing = py::call_guard<DefaultArithmetic>;

// What the library calls settings and files, in a call of Python's: they are its keywords.
std::string keyword(std::string_view name, std::string_view value) {
  std::string text = keyword_name(std::string(name));
  if (!value.empty()) text += "='" + std::string(value) + "'";
  return text;
}

std::string argument(std::string_view name) {
  return std::string(name);
}

std::string shown(const Wording& words) {
  return without_passwords(printable(words.text({keyword, argument})));
}

/// A message with its hint, as the words of an exception or of a warning.
std::string shown(const Message& message) {
  std::string text = shown(message.placed());
  if (!message.hint.empty()) text += "\nhint: " + shown(message.hint);
  return text;
}

std::vector<std::string> shown(const std::vector<Message>& messages) {
  std::vector<std::string> texts;
  texts.reserve(messages.size());
  for (const Message& message : messages) texts.push_back(shown(message));
  return texts;
}

std::string shown(const Error& error) {
  std::string text;
  for (const Message& message : error.messages())
    text += (text.empty() ? "" : "\n") + shown(message);
  if (error.unlisted() > 0) text += "\nand " + std::to_string(error.unlisted()) + " more";
  return text;
}

/// The ids of the stations in a file, in its order.
std::vector<std::string> station_ids(const Keywords& keywords) {
  Warnings told_later;
  const StudyKeywords said(keywords, {}, Call::study, told_later);
  return ids_of(read_stations(said.study.request().stations, told_later).stations);
}

std::optional<GivenReadings> held_readings(const std::optional<Matrix>& matrix,
                                           std::vector<std::string> times) {
  if (!matrix) return std::nullopt;
  if (!times.empty() && times.size() != matrix->steps)
    throw py::value_error("the readings have not as many times as rows");
  return GivenReadings{*matrix, std::move(times)};
}

/// Where the readings of a call are. What is in memory has times where its owner hands them in, or
/// may do so.
ReadingsAt place_of(const std::optional<Doubles>& readings, bool dated) {
  if (!readings) return ReadingsAt::files;
  return dated ? ReadingsAt::dated_memory : ReadingsAt::memory;
}

std::optional<Matrix> matrix_of(const std::optional<Doubles>& readings) {
  if (!readings) return std::nullopt;
  if (readings->ndim() != 2)
    throw py::value_error("readings are not an array of steps by stations");
  return Matrix{readings->data(), static_cast<std::size_t>(readings->shape(0)),
                static_cast<std::size_t>(readings->shape(1))};
}

/// An array that owns what it is made of.
template <typename Number>
py::array owned(std::vector<Number> values, std::vector<py::ssize_t> shape) {
  auto held = std::make_unique<std::vector<Number>>(std::move(values));
  const Number* first = held->data();
  const py::capsule owner(held.release(),
                          [](void* made) { delete static_cast<std::vector<Number>*>(made); });
  return py::array_t<Number>(std::move(shape), first, owner);
}

/// A table of numbers by basin and station, as columns.
class PartsTable {
 public:
  explicit PartsTable(std::size_t numbers) : numbers_(numbers) {}
  void add(std::size_t basin, StationIndex station, const std::vector<double>& numbers) {
    basins_.push_back(basin);
    stations_.push_back(index(station));
    auto column = numbers_.begin();
    for (const double number : numbers) (column++)->push_back(number);
  }
  py::list columns() {
    py::list columns;
    columns.append(
        py::array_t<std::size_t>(static_cast<py::ssize_t>(basins_.size()), basins_.data()));
    columns.append(
        py::array_t<std::size_t>(static_cast<py::ssize_t>(stations_.size()), stations_.data()));
    for (std::vector<double>& column : numbers_) {
      const auto size = static_cast<py::ssize_t>(column.size());
      columns.append(owned(std::move(column), {size}));
    }
    return columns;
  }

 private:
  std::vector<std::size_t> basins_;
  std::vector<std::size_t> stations_;
  std::vector<std::vector<double>> numbers_;
};

/// A factor; NaN where there is no weight.
double factor_of(const StationWeight& part) {
  return part.weight > 0 ? part.factor : std::numeric_limits<double>::quiet_NaN();
}

std::unique_ptr<PythonStudy> make_study(std::optional<StationsFile> stations,
                                        std::optional<BasinsFile> basins,
                                        const std::optional<Doubles>& readings,
                                        const Keywords& keywords, bool times_end_steps,
                                        const py::object& told) {
  GivenParts given{std::move(stations), std::move(basins), matrix_of(readings)};
  given.stamp = times_end_steps ? Stamp::end : Stamp::begin;
  std::unique_ptr<PythonStudy> study;
  wait_for([&] { study = std::make_unique<PythonStudy>(std::move(given), keywords); }, {}, told);
  return study;
}

py::list weights(const PythonStudy& study) {
  std::vector<std::vector<BasinWeights>> weights;
  wait_for([&] { weights = study.weights(); }, {}, py::none());
  const std::size_t factors = study.has_normals() ? weights.size() : 0;
  PartsTable table(2 + factors);
  for (std::size_t b = 0; b < weights.front().size(); ++b) {
    for (std::size_t i = 0; i < weights.front()[b].stations.size(); ++i) {
      const StationWeight& part = weights.front()[b].stations[i];
      std::vector<double> row{part.area * study.inputs().area_unit().km2, part.weight};
      for (std::size_t m = 0; m < factors; ++m) row.push_back(weights[m][b].stations[i].factor);
      table.add(b, part.station, row);
    }
  }
  return table.columns();
}

/// The weights of a study before and after gauges close and open. `never_reporting` are the ids of
/// the study's stations that are not of its network.
py::tuple changed_weights(std::optional<StationsFile> stations, std::optional<BasinsFile> basins,
                          const Keywords& keywords, std::vector<std::string> never_reporting) {
  GivenParts given{std::move(stations),       std::move(basins), std::nullopt, Stamp::begin, true,
                   std::move(never_reporting)};
  Warnings warnings;
  std::unique_ptr<PythonStudy> study;
  ChangedNetwork changed;
  wait_for(
      [&] {
        study = std::make_unique<PythonStudy>(std::move(given), keywords);
        changed = study->changed_weights(warnings);
      },
      {}, py::none());
  std::vector<Message> told = warnings.messages();
  for (const Message& message : study->warnings().messages()) {
    // The study itself has told all others before.
    if (message.file == opened_gauges) told.push_back(message);
  }
  const double km2 = study->inputs().area_unit().km2;
  const std::size_t factors = study->has_normals() ? changed.months.size() : 0;
  PartsTable table(4 + 2 * factors);
  for (std::size_t b = 0; b < changed.months.front().size(); ++b) {
    for (std::size_t i = 0; i < changed.months.front()[b].size(); ++i) {
      const ChangedWeight& part = changed.months.front()[b][i];
      std::vector<double> row{part.before.area * km2, part.before.weight, part.after.area * km2,
                              part.after.weight};
      for (std::size_t m = 0; m < factors; ++m) {
        row.push_back(factor_of(changed.months[m][b][i].before));
        row.push_back(factor_of(changed.months[m][b][i].after));
      }
      table.add(b, part.before.station, row);
    }
  }
  return py::make_tuple(table.columns(), changed.stations, shown(told));
}

py::tuple cells(PythonStudy& study, const std::optional<Doubles>& readings,
                const std::vector<std::string>& times, const Keywords& keywords) {
  const CellsKeywords said(keywords);
  const std::optional<GivenReadings> held = held_readings(matrix_of(readings), times);
  Warnings warnings;
  std::string text;
  wait_for([&] { text = study.cells_geojson(held, said, warnings); }, {}, py::none());
  return py::make_tuple(text, shown(warnings.messages()));
}

/// Throws what is wrong with the keywords of a series, before its readings are known.
void check_series(const Keywords& keywords, const std::optional<bool>& dated, bool stamp_acts) {
  const SeriesKeywords said(keywords,
                            !dated   ? ReadingsAt::unknown
                            : *dated ? ReadingsAt::dated_memory
                                     : ReadingsAt::memory,
                            Call::rain, stamp_acts);
}

py::dict rain(PythonStudy& study, const std::optional<Doubles>& readings, bool dated,
              const std::vector<std::string>& times, const Keywords& keywords,
              const py::object& told) {
  SeriesKeywords said(keywords, place_of(readings, dated), Call::rain, study.stamp_acts());
  const std::optional<GivenReadings> held = held_readings(matrix_of(readings), times);
  Warnings warnings;
  Progress progress;
  Series series;
  wait_for([&] { series = study.rain(held, said, progress, warnings); }, progress, told);
  const auto columns = static_cast<py::ssize_t>(series.names.size());
  const auto steps = columns == 0 ? 0 : static_cast<py::ssize_t>(series.rainfall.size()) / columns;
  py::dict found;
  found["names"] = series.names;
  found["times"] = series.times;
  found["rainfall"] = owned(std::move(series.rainfall), {steps, columns});
  found["warnings"] = shown(warnings.messages());
  // What is not asked for is not there, however many rows there are.
  if (said.errors) found["errors"] = owned(std::move(series.errors), {steps, columns});
  if (said.range.totalling()) found["missing"] = owned(std::move(series.missing), {steps, columns});
  if (held && said.range.times() && !said.range.totalling()) {
    const auto rows = static_cast<py::ssize_t>(series.steps.size());
    found["steps"] = owned(std::move(series.steps), {rows});
  }
  return found;
}

py::tuple influence(PythonStudy& study, const std::optional<Doubles>& readings, bool dated,
                    const std::vector<std::string>& times, const Keywords& keywords,
                    const py::object& told) {
  SeriesKeywords said(keywords, place_of(readings, dated), Call::influence, study.stamp_acts());
  const std::optional<GivenReadings> held = held_readings(matrix_of(readings), times);
  Warnings warnings;
  Progress progress;
  std::vector<std::vector<GaugeInfluence>> found;
  wait_for([&] { found = study.influence(held, said, progress, warnings); }, progress, told);
  PartsTable table(3);
  for (std::size_t b = 0; b < found.size(); ++b) {
    for (const GaugeInfluence& gauge : found[b])
      table.add(b, gauge.station, {gauge.weight, gauge.rms_change, gauge.mean_change});
  }
  return py::make_tuple(table.columns(), shown(warnings.messages()));
}

std::vector<std::string> basin_ids(const PythonStudy& study) {
  std::vector<std::string> ids;
  for (const Basin& basin : study.inputs().basins()) ids.push_back(basin.id);
  return ids;
}

void translate(std::exception_ptr thrown, PyObject* error) {
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const Error& fault) {
    PyErr_SetString(error, shown(fault).c_str());
  } catch (const cli::UsageError& fault) {
    const std::string hint = fault.hint.empty() ? "" : "\nhint: " + in_python(fault.hint);
    PyErr_SetString(error, (in_python(fault.text) + hint).c_str());
  } catch (const UnknownKeyword& fault) {
    PyErr_SetString(PyExc_TypeError, fault.text.c_str());
  } catch (const Interrupted&) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
  }
}

}  // namespace

// In this file alone, but with linkage, for the module's entry lies outside the namespace.
static void declare(py::module_& module) {
  module.attr("__version__") = version();
  static py::exception<Error> error(module, "Error", PyExc_ValueError);
  py::register_exception_translator(
      [](std::exception_ptr thrown) { translate(std::move(thrown), error.ptr()); });
  module.def("geometry_in", geometry_in, computing());
  module.def("known_columns", known_columns, computing());
  module.def("station_ids", station_ids, computing());
  module.def("keywords_of_calls", keywords_of_calls, computing());
  module.def("check_series", check_series, computing());
  module.def("changed_weights", changed_weights, computing());
  py::class_<StationsFile>(module, "Stations").def(py::init(&stations_of), computing());
  py::class_<BasinsFile>(module, "Basins").def(py::init(&basins_of), computing());
  py::class_<PythonStudy>(module, "Study")
      .def(py::init(&make_study), computing())
      .def("weights", weights, computing())
      .def("cells", cells, computing())
      .def("rain", rain, computing())
      .def("influence", influence, computing())
      .def_property_readonly("has_readings", &PythonStudy::has_readings)
      .def_property_readonly("stamp_acts", &PythonStudy::stamp_acts)
      .def_property_readonly("tells_months", &PythonStudy::tells_months)
      .def_property_readonly("given_ids", &PythonStudy::given_ids)
      .def_property_readonly(
          "stations",
          [](const PythonStudy& study) { return ids_of(study.inputs().network().stations()); })
      .def_property_readonly("positions",
                             [](const PythonStudy& study) {
                               return positions_of(study.inputs().network().stations());
                             })
      .def_property_readonly(
          "never_reporting",
          [](const PythonStudy& study) { return ids_of(study.inputs().never_reporting()); })
      .def_property_readonly("basins", basin_ids)
      .def_property_readonly("metric",
                             [](const PythonStudy& study) {
                               return study.inputs().study().metric == Metric::geodesic ? "geodesic"
                                                                                        : "planar";
                             })
      .def_property_readonly(
          "area_column",
          [](const PythonStudy& study) { return study.inputs().area_unit().column(); })
      .def_property_readonly(
          "warnings", [](const PythonStudy& study) { return shown(study.warnings().messages()); })
      .def_property_readonly(
          "notices", [](const PythonStudy& study) { return shown(study.warnings().notices()); });
}

}  // namespace thiessen::python

PYBIND11_MODULE(_thiessen, module) {
  thiessen::python::declare(module);
}
