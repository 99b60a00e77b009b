#include "files/cells_file.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/error.h"
#include "base/interrupt.h"
#include "base/number.h"
#include "base/utf8.h"
#include "files/cells_shapes.h"
#include "gdal/output/cells_layer.h"
#include "gdal/output/layer_formats.h"
#include "outlines/cell_validity.h"
#include "outlines/polygon_validity.h"
#include "outlines/vertex_rounding.h"
#include "results/cells_geojson.h"

namespace thiessen {
namespace {

bool is_geojson(const std::string& extension) {
  return extension == "geojson" || extension == "json";
}

/// The shapes of the cells in `target`, and which of them are of one basin.
CellShapes shapes_in(const CellsOutput& output, const std::optional<Crs>& target) {
  CellShapes cells{cells_shapes(output, target), {}, 0};
  std::size_t basin = 0;
  for (std::size_t i = 0; i < output.cells.size(); ++i) {
    if (i > 0 && output.cells[i].basin != output.cells[i - 1].basin) ++basin;
    cells.basins.push_back(basin);
  }
  return cells;
}

std::string cell_words(const CellFeature& cell) {
  return "the cell of station " + quoted(cell.station, 80) +
         (cell.basin ? " in basin " + quoted(*cell.basin, 80) : "");
}

/// Throws Error with the cells that are no valid shape.
void refuse_any(const std::vector<std::size_t>& faulty, const CellsOutput& output,
                const CellShapes& cells) {
  Complaints complaints;
  for (const std::size_t i : faulty) {
    complaints.add({"", 0,
                    cell_words(output.cells[i]) +
                        " cannot be written as a valid shape: " + validity_fault(cells.shapes[i]),
                    "the basin's outline is at fault there, or finer than its coordinates"});
  }
  complaints.throw_if_any();
}

/// How fine slivers are collapsed, in the unit of `crs`: a hundredth of the tolerance.
double sliver_width(const CellsOutput& output, const std::optional<Crs>& crs,
                    const CellShapes& cells) {
  if (!crs) return finest_grid(cells.shapes);
  if (crs->geographic())
    return std::pow(10, -1 - decimals_for(output.tolerance)) / crs->degrees_per_unit();
  return output.tolerance / 100 / crs->metres_per_unit();
}

/// Tells what the outlines lack: slivers, and whole cells that are no wider.
void tell_collapsed(const CellShapes& cells, const CellsOutput& output, const std::string& file,
                    Warnings& warnings) {
  if (cells.collapsed > 0) {
    warnings.add_notice({file,
                         0,
                         "the cells' outlines are without needles and slivers, in " +
                             std::to_string(cells.collapsed) +
                             (cells.collapsed == 1 ? " basin" : " basins") +
                             ": what is narrower than a hundredth of the tolerance is in areas and "
                             "weights only",
                         {}});
  }
  const auto is_lost = [](const MultiPolygon& shape) { return shape.empty(); };
  const auto lost = std::count_if(cells.shapes.begin(), cells.shapes.end(), is_lost);
  if (lost == 0) return;
  const auto first = std::find_if(cells.shapes.begin(), cells.shapes.end(), is_lost);
  std::string text =
      cell_words(output.cells[static_cast<std::size_t>(first - cells.shapes.begin())]);
  if (lost > 1) text += ", and " + std::to_string(lost - 1) + " more,";
  warnings.add(
      {file, 0, text + " has no geometry: it is narrower than the coordinates can tell", {}});
}

CellShapes valid_shapes_in(const CellsOutput& output, const std::optional<Crs>& crs,
                           const std::string& file, Warnings& warnings) {
  CellShapes cells = shapes_in(output, crs);
  refuse_any(make_valid(cells, sliver_width(output, crs, cells)), output, cells);
  tell_collapsed(cells, output, file, warnings);
  return cells;
}

/// The number under which PostGIS knows a CRS: its code of EPSG; 0 where it has none.
int srid_of(const std::optional<Crs>& crs) {
  constexpr std::string_view epsg = "EPSG:";
  constexpr int wgs84 = 4326;
  if (!crs) return 0;
  if (crs->is_wgs84()) return wgs84;
  if (!crs->name().starts_with(epsg)) return 0;
  const auto code = parse_number(crs->name().substr(epsg.size()));
  return code ? static_cast<int>(code.value) : 0;
}

}  // namespace

void cells_table(const CellsOutput& output, DatabaseTable& table, Warnings& warnings) {
  const std::optional<Crs> crs = output.file_crs ? output.file_crs : output.study_crs;
  const int srid = srid_of(crs);
  if (srid == 0) {
    warnings.add({table.name(), 0,
                  crs ? "its geometries have no SRID, for " + crs->name() + " has no EPSG code"
                      : "its geometries have no SRID, for no CRS is known",
                  ""});
  }
  const CellShapes cells = valid_shapes_in(output, crs, table.name(), warnings);
  const std::vector<std::string> names =
      append_cell_rows(table.rows(), output, cells.shapes, DatabaseTable::geometry_column, srid);
  const std::size_t own = names.size() - 1 - attribute_fields(output).size();
  table.commit(sentence_of(output.made_by.value_or(Provenance())), names, srid, own);
}

std::string cells_geojson(const CellsOutput& output, const std::string& file, Warnings& warnings) {
  if (!output.study_crs)
    return cells_geojson(output, valid_shapes_in(output, {}, file, warnings).shapes,
                         VertexRounding());
  CellShapes cells = shapes_in(output, Crs::wgs84());
  const VertexRounding rounding = round_cells(cells, decimals_for(output.tolerance));
  refuse_any(rounding.faulty(), output, cells);
  tell_collapsed(cells, output, file, warnings);
  return cells_geojson(output, cells.shapes, rounding);
}

bool append_cells_geojson(OutputFile& file, const CellsOutput& output, const CellSource& cells) {
  if (output.study_crs) return false;
  constexpr std::size_t block = 1U << 16U;
  const VertexRounding every_digit;
  CellsGeojson geojson(output, every_digit);
  std::string text;
  geojson.begin(text);
  bool are_valid = true;
  cells([&](const CellFeature& cell) {
    throw_if_interrupted();
    are_valid = !cell.shape.empty() && is_writable(cell.shape);
    if (!are_valid) return false;
    geojson.append(text, cell, cell.shape);
    if (text.size() >= block) {
      file.append(text);
      text.clear();
    }
    return true;
  });
  if (!are_valid) {
    file.start_over();
    return false;
  }
  geojson.end(text);
  file.append(text);
  return true;
}

void warn_of_new_names(const CellsOutput& output, const std::string& file, Warnings& warnings) {
  const std::vector<FieldName> written = attribute_fields(output);
  for (std::size_t i = 0; i < written.size(); ++i) {
    const std::string& name = output.attributes->fields[i].name;
    if (name == written[i].name) continue;
    warnings.add({file,
                  0,
                  "the station's field " + quoted(name, 80) + " is called " +
                      quoted(written[i].name, 80) + " beside the cell's own",
                  {}});
  }
}

bool is_cells_geojson(const std::string& path) {
  return is_geojson(extension_of(path));
}

void require_cells_format(const std::string& path) {
  if (!is_geojson(extension_of(path))) require_cells_driver(path);
}

std::vector<EncodedFile> cells_files(const CellsOutput& output, const std::string& path,
                                     Warnings& warnings, const std::string& older) {
  const std::string extension = extension_of(path);
  if (is_geojson(extension)) return {{path, cells_geojson(output, path, warnings)}};
  require_cells_driver(path);
  std::optional<Crs> crs = output.file_crs ? output.file_crs : output.study_crs;
  require_known_degrees(path, output.study_crs.has_value());
  if (holds_degrees_only(extension)) crs = Crs::wgs84();
  return write_cells_layer(output, valid_shapes_in(output, crs, path, warnings).shapes, crs, path,
                           older, warnings);
}

}  // namespace thiessen
