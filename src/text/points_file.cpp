#include "text/points_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "geometry/coordinates.h"
#include "geometry/exact_range.h"
#include "geometry/predicates.h"
#include "text/csv_reader.h"
#include "text/field_names.h"
#include "text/last_line.h"

namespace thiessen {
namespace {

constexpr std::array<std::string_view, 5> x_names = {"x", "lon", "long", "longitude", "easting"};
constexpr std::array<std::string_view, 4> y_names = {"y", "lat", "latitude", "northing"};
constexpr std::array<std::string_view, 4> z_names = {"z", "height", "elevation", "altitude"};
constexpr std::array<std::span<const std::string_view>, 3> coordinate_names = {x_names, y_names,
                                                                               z_names};

/// Reads points, one row at a time.
template <std::size_t Axes>
class PointsReader {
 public:
  using Coordinates = std::array<double, Axes>;

  PointsReader(InputFile file, Warnings& warnings)
      : reader_(std::move(file), {',', {}, false}), warnings_(warnings) {
    if (find_fields()) {
      reader_.check_header();
      return;
    }
    has_header_ = false;
    const auto& first = reader_.header();
    const bool has_number = std::any_of(first.begin(), first.end(), [](const std::string& field) {
      return parse_number(field).fault != NumberFault::not_a_number;
    });
    if (!has_number) fail_without_names();
    if (first.size() != Axes) fail_with_other_fields();
    for (std::size_t axis = 0; axis < Axes; ++axis) field_[axis] = axis;
  }

  /// Calls `visit(coordinates)` for every point. Throws Error with everything that is bad.
  template <typename Visit>
  void read(Visit visit) {
    Row row;
    bool has_row = !has_header_;
    if (has_row) {
      row.line = reader_.header_line();
      row.fields.assign(reader_.header().begin(), reader_.header().end());
    } else {
      has_row = next(row);
    }
    for (; has_row; has_row = next(row)) {
      ++rows_;
      if (const auto coordinates = read_row(row)) visit(*coordinates);
    }
    complaints_.throw_if_any();
    if (rows_ == 0) throw Error(Message{"", 0, "no points in " + reader_.file(), {}});
  }

 private:
  bool next(Row& row) {
    try {
      return reader_.next(row);
    } catch (const Error& error) {
      complaints_.add(error);
      return false;
    }
  }

  bool find_fields() {
    const auto& header = reader_.header();
    for (std::size_t axis = 0; axis < Axes; ++axis) {
      const auto found = find_field(header, coordinate_names[axis]);
      if (!found) return false;
      field_[axis] = *found;
    }
    if (Axes == 2 && find_field(header, coordinate_names[2]))
      warnings_.add({reader_.file(), 0, "heights (z) are passed over", {}});
    return true;
  }

  [[noreturn]] void fail_without_names() const {
    std::string wanted;
    for (std::size_t axis = 0; axis < Axes; ++axis) {
      if (axis > 0) wanted += ", and ";
      const auto names = coordinate_names[axis];
      for (const std::string_view name : names)
        wanted += (name == names.front() ? "" : ", ") + std::string(name);
    }
    fail("no field of coordinates: wanted " + wanted + "; found " + listed(reader_.header()),
         "fields are parted by commas");
  }
  [[noreturn]] void fail_with_other_fields() const {
    const std::size_t count = reader_.header().size();
    fail("without a header, rows are " + std::to_string(Axes) + " coordinates, and this has " +
             std::to_string(count) + (count == 1 ? " field" : " fields"),
         count > Axes ? "a header names the fields: x, y" + std::string(Axes == 3 ? ", z" : "")
                      : "fields are parted by commas");
  }
  [[noreturn]] void fail(std::string text, std::string hint) const {
    throw Error(Message{reader_.file(), reader_.header_line(), std::move(text), std::move(hint)});
  }

  std::optional<Coordinates> read_row(const Row& row) {
    Coordinates coordinates{};
    bool good = true;
    for (std::size_t axis = 0; axis < Axes; ++axis) {
      const auto value = read_number(row, axis);
      good = good && value;
      if (value) coordinates[axis] = *value + 0.0;  // -0 becomes 0
    }
    if (!good) return std::nullopt;
    return coordinates;
  }

  std::optional<double> read_number(const Row& row, std::size_t axis) {
    const std::string_view text = trimmed(row.fields[field_[axis]]);
    const auto number = parse_number(text);
    if (number && in_exact_range(number.value)) return number.value;
    const std::string name =
        has_header_ ? quoted(reader_.header()[field_[axis]], 40) : std::string(axis_names[axis]);
    if (text.empty()) {
      complain(row, name + " is empty");
    } else if (number.fault == NumberFault::not_a_number) {
      complain(row, name + " is no number: " + quoted(text, 60));
    } else {
      complain(row, name + " is " + std::string(outside_exact_range) + ": " + quoted(text, 60));
    }
    return std::nullopt;
  }
  void complain(const Row& row, std::string text) {
    complaints_.add({reader_.file(), row.line, std::move(text), {}});
  }

  CsvReader reader_;
  Warnings& warnings_;
  Complaints complaints_;
  bool has_header_ = true;
  std::array<std::size_t, Axes> field_{};
  std::size_t rows_ = 0;
};

}  // namespace

template <int Dimension>
std::vector<PositionIn<Dimension>> read_points(const std::string& file, Warnings& warnings) {
  return read_points<Dimension>(InputFile(file), warnings);
}

template <int Dimension>
std::vector<PositionIn<Dimension>> read_points(InputFile file, Warnings& warnings) {
  tell_of_last_line(file.name(), warnings);
  std::vector<PositionIn<Dimension>> points;
  PointsReader<std::size_t{Dimension}>(std::move(file), warnings).read([&](const auto& at) {
    if constexpr (Dimension == 2) {
      points.push_back({at[0], at[1]});
    } else {
      points.push_back({at[0], at[1], at[2]});
    }
  });
  return points;
}

template std::vector<Point> read_points<2>(const std::string&, Warnings&);
template std::vector<SpacePoint> read_points<3>(const std::string&, Warnings&);
template std::vector<Point> read_points<2>(InputFile, Warnings&);
template std::vector<SpacePoint> read_points<3>(InputFile, Warnings&);

}  // namespace thiessen
