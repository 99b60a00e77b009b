#include "gdal/layers/netcdf_length.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "base/interrupt.h"

namespace thiessen {
namespace {

// The header, in numbers of the largest byte first: magic; the number of records; lists of
// dimensions, attributes and variables, each behind a tag. Names and values are filled up to 4
// bytes. Source: NetCDF User's Guide, File Format Specifications.
constexpr std::uint64_t most_dimensions = 1024;
constexpr std::uint64_t most_of_a_list = 1U << 20U;
constexpr std::uint64_t least_of_an_entry = 8;  // bytes: the length of a name, and another number
constexpr std::uint64_t most_bytes = std::numeric_limits<std::int64_t>::max();  // of any file

/// What ends the search: a header that is not whole, of which the library reads zeros, too.
struct NoHeader {};

struct Variable {
  bool has_records = false;
  std::uint64_t bytes = 0;  ///< of the variable, or of its part of a record
  std::uint64_t begin = 0;
};

class Header {
 public:
  /// `size` is how many bytes the file has: nothing in a header is larger.
  Header(const std::string& file, std::uint64_t size)
      : bytes_(file, std::ios::binary), left_(size) {}

  /// Where the last value ends; 0 where the header does not say.
  std::uint64_t end_of_values() {
    if (left_ < 3 || number(3) != magic) return 0;
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
      if (byte < 0 || left_ == 0) throw NoHeader{};
      --left_;
      value = value << 8U | static_cast<std::uint64_t>(byte);
    }
    return value;
  }
  std::uint64_t count() { return number(version_ == 5 ? 8 : 4); }
  std::uint64_t length_of_list() {
    number(4);  // the tag; of an empty list it is 0
    const std::uint64_t length = count();
    if (length > most_of_a_list || length > left_ / least_of_an_entry) throw NoHeader{};
    return length;
  }
  void pass(std::uint64_t size) {
    if (size > left_ || filled_up(size) > left_) throw NoHeader{};
    left_ -= filled_up(size);
    bytes_.seekg(static_cast<std::streamoff>(filled_up(size)), std::ios::cur);
    if (!bytes_) throw NoHeader{};
  }
  void pass_name() { pass(count()); }

  /// What a header counts with is checked first: numbers that wrapped would lead back into it, or
  /// to an end that is none.
  static std::uint64_t product(std::uint64_t a, std::uint64_t b) {
    if (a != 0 && b > most_bytes / a) throw NoHeader{};
    return a * b;
  }
  static std::uint64_t sum(std::uint64_t a, std::uint64_t b) {
    if (a > most_bytes || b > most_bytes - a) throw NoHeader{};
    return a + b;
  }
  static std::uint64_t filled_up(std::uint64_t size) { return (size + 3) / 4 * 4; }
  static std::uint64_t bytes_of_type(std::uint64_t type) {
    constexpr std::uint64_t sizes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    if (type >= std::size(sizes)) throw NoHeader{};
    return sizes[type];
  }

  std::vector<std::uint64_t> read_dimensions() {
    std::vector<std::uint64_t> lengths(length_of_list());
    for (std::uint64_t& length : lengths) {
      throw_if_interrupted();
      pass_name();
      length = count();
    }
    return lengths;
  }
  void pass_attributes() {
    for (std::uint64_t left = length_of_list(); left > 0; --left) {
      throw_if_interrupted();
      pass_name();
      const std::uint64_t size = bytes_of_type(number(4));
      pass(product(size, count()));
    }
  }

  std::vector<Variable> read_variables(const std::vector<std::uint64_t>& dimensions) {
    std::vector<Variable> variables(length_of_list());
    for (Variable& variable : variables) {
      throw_if_interrupted();
      pass_name();
      std::uint64_t values = 1;
      const std::uint64_t axes = count();
      if (axes > most_dimensions) throw NoHeader{};
      for (std::uint64_t axis = 0; axis < axes; ++axis) {
        const std::uint64_t length = dimension(dimensions);
        if (axis == 0 && length == 0) {
          variable.has_records = true;
        } else {
          values = product(values, length);
        }
      }
      pass_attributes();
      variable.bytes = product(values, bytes_of_type(number(4)));
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
      if (one.has_records) record = sum(record, of_records == 1 ? one.bytes : filled_up(one.bytes));
    }
    std::uint64_t end = 0;
    for (const Variable& one : variables) {
      if (!one.has_records) end = std::max(end, sum(one.begin, one.bytes));
      if (one.has_records && records > 0)
        end = std::max(end, sum(one.begin, sum(product(records - 1, record), one.bytes)));
    }
    return end;
  }

  std::ifstream bytes_;
  std::uint64_t left_;  ///< bytes of the file that are not read yet
  std::uint64_t version_ = 0;
};

}  // namespace

void require_whole_netcdf(const std::string& file) {
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(file, none);
  if (none) return;
  std::uint64_t wanted = 0;
  try {
    wanted = Header(file, size).end_of_values();
  } catch (const NoHeader&) {
    throw Error(Message{file, 0, "is cut off: its header is not whole", {}});
  }
  if (size >= wanted) return;
  throw Error(Message{file,
                      0,
                      "is cut off: " + std::to_string(size) + " of its " + std::to_string(wanted) +
                          " bytes are there",
                      {}});
}

}  // namespace thiessen
