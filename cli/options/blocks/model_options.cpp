#include "cli/options/blocks/model_options.h"

#include <stdexcept>

#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"
#include "files/database/postgres.h"

namespace thiessen::cli {
namespace {

/// Whether values are in millimetres whatever a label says.
bool has_own_unit(RainModel model) {
  switch (model) {
    case RainModel::netcdf:
    case RainModel::pi_xml:
      return false;
    case RainModel::hype:
    case RainModel::swat:
    case RainModel::swmm:
      return true;
  }
  throw std::logic_error("not a model's format");
}

}  // namespace

void RainModelOptions::declare(OptionList& options) {
  OptionGroup output = options.group("Output", *this);
  format_option_ = &output.add(
      "--format",
      choice<std::optional<RainModel>>(model_, {{"csv", std::nullopt},
                                                {"netcdf", RainModel::netcdf},
                                                {"hype", RainModel::hype},
                                                {"swat", RainModel::swat},
                                                {"swmm", RainModel::swmm},
                                                {"pi-xml", RainModel::pi_xml}}),
      "what the next model reads, under any name: CF time series, HYPE's Pobs.txt, SWAT+'s .pcp "
      "with pcp.cli (FILE is a folder), SWMM's rain file, Delft-FEWS's PI-XML; default csv");
  units_option_ = &output.add("--units", any_text(units, "U"),
                              "with --format netcdf or pi-xml, or into a database: what readings "
                              "of no known unit are in; default mm");
}

void RainModelOptions::check(const OptionList& options, const std::string& output,
                             std::size_t methods) const {
  if (!model_) {
    if (!are_units_given() || thiessen::is_database(output)) return;
    throw UsageError{"--units is about what a model reads, and a CSV names no unit",
                     "--format netcdf and --format pi-xml do"};
  }
  const std::string format = "--format " + name();
  const auto refuse = [&](const char* name, const std::string& why, const std::string& hint) {
    if (!options.at(name).is_given()) return;
    throw UsageError{std::string(name) + ' ' + why, hint};
  };
  const std::string leave_out = "leave one of them out";
  refuse("--long", "is about the rows of a CSV, and " + format + " has its own", leave_out);
  refuse("--iso-times", "is about the times of a CSV, and " + format + " has its own", leave_out);
  refuse("--append", "adds to a CSV, and " + format + " is written anew",
         "--overwrite replaces what is there");
  if (model_ == RainModel::netcdf) {
    refuse("--decimals", "is about values as text, and a NetCDF holds all digits", leave_out);
  } else {
    refuse("--error", "is beside the values, and " + format + " has no place for it",
           "--format csv and --format netcdf have");
  }
  if (has_own_unit(*model_)) {
    refuse("--units", "is a label, and " + format + " has none",
           "--from-unit says what the readings are in, and they are brought to mm");
  }
  if (methods > 1) {
    throw UsageError{"--method says several, and " + format + " holds one series a basin",
                     "give one of them"};
  }
  check_output(output);
}

void RainModelOptions::check_output(const std::string& output) const {
  const std::string format = "--format " + name();
  if (thiessen::is_database(output)) {
    throw UsageError{format + " is a file, and the output is a database",
                     "-o FILE names one; without --format the database has a table"};
  }
  if (output != "-") return;
  if (model_ == RainModel::netcdf)
    throw UsageError{format + " cannot go to the standard output", "-o rain.nc names a file"};
  if (model_ == RainModel::swat)
    throw UsageError{format + " writes a folder, not the standard output", "-o DIR names it"};
}

void WeightsModelOptions::declare(OptionList& options) {
  format_option_ =
      &options.group("Output", *this)
           .add("--format",
                choice<std::optional<WeightsModel>>(model_, {{"csv", std::nullopt},
                                                             {"hms", WeightsModel::hms},
                                                             {"raven", WeightsModel::raven}}),
                "what the next model reads, under any name: a .met of HEC-HMS with gage weights, "
                "Raven's "
                ":GaugeWeightTable; default csv");
}

void WeightsModelOptions::check(const OtherTable& other) const {
  if (!model_) return;
  const std::string format = "--format " + format_option_->texts.back();
  if (other.is_influence) {
    throw UsageError{"--influence is a table of its own, and " + format + " holds weights",
                     "leave one of them out"};
  }
  if (other.is_change) {
    throw UsageError{"--with and --without compare two networks, and " + format + " holds one",
                     "--stations-where leaves stations out of the network"};
  }
  if (!other.is_database) return;
  throw UsageError{format + " is a file, and the output is a database",
                   "-o FILE names one; without --format the database has a table"};
}

}  // namespace thiessen::cli
