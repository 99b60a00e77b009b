#include "tessellation/topology_table_reader.h"

#include <algorithm>
#include <optional>

#include "base/number.h"
#include "base/utf8.h"
#include "geometry/coordinates.h"
#include "geometry/exact_range.h"
#include "geometry/predicates.h"

namespace thiessen {
namespace {

constexpr std::string_view blanks = " \t";

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (;;) {
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(blanks)));
    if (line.empty()) return words;
    const std::size_t end = std::min(line.size(), line.find_first_of(blanks));
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

/// A number that a point or a vertex may have, from 1; nothing where the text is none. None is so
/// large that no number would follow it.
std::optional<std::uint64_t> read_id(std::string_view text) {
  constexpr std::uint64_t largest = std::uint64_t{1} << 62;
  const auto number = parse_size(text);
  if (!number || number.value == 0 || number.value > largest) return std::nullopt;
  return number.value;
}

std::string form_of_point(int dimension) {
  return dimension == 2 ? "`point ID X Y`" : "`point ID X Y Z`";
}
std::string form_of_vertex(int dimension) {
  return dimension == 2
             ? "`vertex ID center X Y radius R forming F1 F2 F3 neighbors N1 N2 N3`"
             : "`vertex ID center X Y Z radius R forming F1 F2 F3 F4 neighbors N1 N2 N3 N4`";
}

template <int Dimension>
PositionIn<Dimension> position_of(const CoordinatesIn<Dimension>& at) {
  if constexpr (Dimension == 2) {
    return {at[0], at[1]};
  } else {
    return {at[0], at[1], at[2]};
  }
}

}  // namespace

template <int Dimension>
bool TopologyTableReader<Dimension>::begins_table(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  return words.size() >= 2 && words[0] == "point" && read_id(words[1]).has_value();
}

template <int Dimension>
void TopologyTableReader<Dimension>::take(std::string_view line, std::size_t number) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.empty() || words[0].front() == '#') return;
  if (words[0] == "point") {
    take_point(words, number);
  } else if (words[0] == "vertex") {
    take_vertex(words, number);
  } else {
    complain(number, "a line begins with point or vertex, not with " + quoted(words[0], 40));
  }
}

template <int Dimension>
void TopologyTableReader<Dimension>::take_point(std::span<const std::string_view> words,
                                                std::size_t line) {
  CoordinatesIn<Dimension> at{};
  if (words.size() != 2 + at.size()) {
    const std::string hint = words.size() == 1 + at.size() + 2 && Dimension == 2
                                 ? "a session in three dimensions takes points in space"
                                 : "";
    return complain(line, "the line of a point is " + form_of_point(Dimension), hint);
  }
  const auto number = read_id(words[1]);
  if (!number)
    return complain(line, "a point's number is no whole number from 1: " + quoted(words[1], 60));
  for (std::size_t axis = 0; axis < at.size(); ++axis) {
    const auto value = parse_number(words[2 + axis]);
    const std::string name(axis_names.at(axis));
    if (!value && value.fault == NumberFault::not_a_number)
      return complain(line, name + " is no number: " + quoted(words[2 + axis], 60));
    if (!value || !in_exact_range(value.value))
      return complain(line, name + " is " + std::string(outside_exact_range) + ": " +
                                quoted(words[2 + axis], 60));
    at.at(axis) = value.value + 0.0;  // adding zero turns -0 into 0
  }
  points_.push_back({*number, position_of<Dimension>(at), line});
}

template <int Dimension>
void TopologyTableReader<Dimension>::take_vertex(std::span<const std::string_view> words,
                                                 std::size_t line) {
  constexpr std::size_t corners = Dimension + 1;
  constexpr std::size_t centre = 2;
  constexpr std::size_t radius = centre + 1 + Dimension;
  constexpr std::size_t forming = radius + 2;
  constexpr std::size_t neighbours = forming + 1 + corners;
  const bool is_in_form = words.size() == neighbours + 1 + corners && words[centre] == "center" &&
                          words[radius] == "radius" && words[forming] == "forming" &&
                          words[neighbours] == "neighbors";
  if (!is_in_form) return complain(line, "the line of a vertex is " + form_of_vertex(Dimension));
  NumberedVertex<Dimension> vertex;
  vertex.line = line;
  const auto read = [&](std::size_t word, bool may_be_none, std::uint64_t& into) {
    const auto number = read_id(words[word]);
    const bool is_none = may_be_none && words[word] == "0";
    if (!number && !is_none)
      complain(line, "no number of a point or a vertex: " + quoted(words[word], 60));
    into = number.value_or(0);
    return number || is_none;
  };
  bool is_good = read(1, false, vertex.number);
  for (std::size_t i = 0; i < corners && is_good; ++i)
    is_good = read(forming + 1 + i, false, vertex.forming.at(i)) &&
              read(neighbours + 1 + i, true, vertex.neighbours.at(i));
  if (is_good) vertices_.push_back(vertex);
}

template <int Dimension>
NumberedTable<Dimension> TopologyTableReader<Dimension>::table() && {
  const auto by_number = [](const auto& a, const auto& b) { return a.number < b.number; };
  std::stable_sort(points_.begin(), points_.end(), by_number);
  refuse_repeated();
  complaints_.throw_if_any();
  NumberedTable<Dimension> table;
  table.file = file_;
  table.numbers.reserve(points_.size());
  table.positions.reserve(points_.size());
  for (const NumberedPoint& point : points_) {
    table.numbers.push_back(point.number);
    table.positions.push_back(point.position);
  }
  table.vertices = std::move(vertices_);
  return table;
}

// Requires points in the order of their numbers.
template <int Dimension>
void TopologyTableReader<Dimension>::refuse_repeated() {
  for (std::size_t i = 1; i < points_.size(); ++i) {
    if (points_[i].number != points_[i - 1].number) continue;
    complain(points_[i].line, "point " + std::to_string(points_[i].number) +
                                  " is told of in line " + std::to_string(points_[i - 1].line) +
                                  " already");
  }
  std::vector<std::size_t> order(points_.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (points_[a].position != points_[b].position)
      return points_[a].position < points_[b].position;
    return points_[a].line < points_[b].line;
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    const NumberedPoint& first = points_[order[i - 1]];
    const NumberedPoint& second = points_[order[i]];
    if (first.position != second.position || first.number == second.number) continue;
    complain(second.line, "point " + std::to_string(second.number) + " is where point " +
                              std::to_string(first.number) + " is, in line " +
                              std::to_string(first.line));
  }
}

template <int Dimension>
void TopologyTableReader<Dimension>::complain(std::size_t line, std::string text,
                                              std::string hint) {
  complaints_.add_by_line({file_, line, std::move(text), std::move(hint)});
}

template class TopologyTableReader<2>;
template class TopologyTableReader<3>;

}  // namespace thiessen
