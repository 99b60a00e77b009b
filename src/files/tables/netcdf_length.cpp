#include "files/tables/netcdf_length.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include "base/error.h"

namespace thiessen {
namespace {

// The header, in numbers of the largest byte first: magic; the number of records; lists of
// dimensions, attributes and variables, each behind a tag. Names and values are filled up to 4
// bytes. Source: NetCDF User's Guide, File Format Specifications.
constexpr std::uint64_t most_dimensions = 1024;
constexpr std::uint64_t most_of_a_list = 1U << 20U;

/// What ends the search: a header that is not whole, of which the library reads zeros, too.
struct NoHeader {};

struct Variable {
  bool has_records = false;
  std::uint64_t bytes = 0;  ///< of the variable, or of its part of a record
  std::uint64_t begin = 0;
};

class Header {
 public:
  explicit Header(const std::string& file) : bytes_(file, std::ios::binary) {}

  /// Where the last value ends; 0 where the header does not say.
  std::uint64_t end_of_values() {
    std::uint64_t first = 0;
    for (int i = 0; i < 3; ++i)
      first = first << 8U | static_cast<std::uint64_t>(std::max(bytes_.get(), 0));
    if (first != magic) return 0;
    version_ = number(1);
    if (version_ != 1 && version_ != 2 && version_ != 5) return 0;
    const std::uint64_t records = count();
    const bool is_counted = records != (version_ == 5 ? ~std::uint64_t{0} : 0xFFFFFFFFu);
    const std::vector<std::uint64_t> dimensions = read_dimensions();
    pass_attributes();
    const std::vector<Variable> variables = read_variables(dimensions);
    if (!is_counted) return 0;
    return last_end(variables, records);
  }

 private:
  static constexpr std::uint64_t magic = 0x434446;  // CDF

  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const int byte = bytes_.get();
      if (byte < 0) throw NoHeader{};
      value = value << 8U | static_cast<std::uint64_t>(byte);
    }
    return value;
  }
  std::uint64_t count() { return number(version_ == 5 ? 8 : 4); }
  std::uint64_t length_of_list() {
    number(4);  // the tag; of an empty list it is 0
    const std::uint64_t length = count();
    if (length > most_of_a_list) throw NoHeader{};
    return length;
  }
  void pass(std::uint64_t size) {
    bytes_.seekg(static_cast<std::streamoff>(filled_up(size)), std::ios::cur);
    if (!bytes_) throw NoHeader{};
  }
  void pass_name() { pass(count()); }

  static std::uint64_t filled_up(std::uint64_t size) { return (size + 3) / 4 * 4; }
  static std::uint64_t bytes_of_type(std::uint64_t type) {
    constexpr std::uint64_t sizes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    if (type >= std::size(sizes)) throw NoHeader{};
    return sizes[type];
  }

  std::vector<std::uint64_t> read_dimensions() {
    std::vector<std::uint64_t> lengths(length_of_list());
    for (std::uint64_t& length : lengths) {
      pass_name();
      length = count();
    }
    return lengths;
  }
  void pass_attributes() {
    for (std::uint64_t left = length_of_list(); left > 0; --left) {
      pass_name();
      const std::uint64_t size = bytes_of_type(number(4));
      pass(size * count());
    }
  }

  std::vector<Variable> read_variables(const std::vector<std::uint64_t>& dimensions) {
    std::vector<Variable> variables(length_of_list());
    for (Variable& variable : variables) {
      pass_name();
      std::uint64_t values = 1;
      const std::uint64_t axes = count();
      if (axes > most_dimensions) throw NoHeader{};
      for (std::uint64_t axis = 0; axis < axes; ++axis) {
        const std::uint64_t length = dimension(dimensions);
        if (axis == 0 && length == 0) {
          variable.has_records = true;
        } else {
          values *= length;
        }
      }
      pass_attributes();
      variable.bytes = values * bytes_of_type(number(4));
      count();  // the same size as it is stated, which has room for 4 GB alone
      variable.begin = number(version_ == 1 ? 4 : 8);
    }
    return variables;
  }
  std::uint64_t dimension(const std::vector<std::uint64_t>& dimensions) {
    const std::uint64_t id = count();
    if (id >= dimensions.size()) throw NoHeader{};
    return dimensions[id];
  }

  /// Records follow each other, each of all variables that have them. Where there is one such
  /// variable its parts are not filled up.
  static std::uint64_t last_end(const std::vector<Variable>& variables, std::uint64_t records) {
    std::uint64_t record = 0;
    const auto of_records = std::count_if(variables.begin(), variables.end(),
                                          [](const Variable& one) { return one.has_records; });
    for (const Variable& one : variables) {
      if (one.has_records) record += of_records == 1 ? one.bytes : filled_up(one.bytes);
    }
    std::uint64_t end = 0;
    for (const Variable& one : variables) {
      if (!one.has_records) end = std::max(end, one.begin + one.bytes);
      if (one.has_records && records > 0)
        end = std::max(end, one.begin + (records - 1) * record + one.bytes);
    }
    return end;
  }

  std::ifstream bytes_;
  std::uint64_t version_ = 0;
};

}  // namespace

void require_whole_netcdf(const std::string& file) {
  std::uint64_t wanted = 0;
  try {
    wanted = Header(file).end_of_values();
  } catch (const NoHeader&) {
    throw Error(Message{file, 0, "is cut off: its header is not whole", {}});
  }
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(file, none);
  if (none || size >= wanted) return;
  throw Error(Message{file,
                      0,
                      "is cut off: " + std::to_string(size) + " of its " + std::to_string(wanted) +
                          " bytes are there",
                      {}});
}

}  // namespace thiessen
