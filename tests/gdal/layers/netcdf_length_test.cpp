#include "gdal/layers/netcdf_length.h"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cstdint>
#include <string>
#include <utility>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

/// A file of two variables with records, of 3 bytes and of 8, one without, and attributes.
std::string bytes_of(const TemporaryFolder& folder, int format, int records) {
  const std::string path = folder.path("w.nc");
  int file = 0, time = 0, place = 0, variable = 0;
  nc_create(path.c_str(), NC_CLOBBER | format, &file);
  nc_def_dim(file, "time", NC_UNLIMITED, &time);
  nc_def_dim(file, "place", 3, &place);
  const int axes[] = {time, place};
  nc_def_var(file, "quality", NC_BYTE, 2, axes, &variable);
  nc_put_att_text(file, variable, "units", 5, "codes");
  nc_def_var(file, "x", NC_DOUBLE, 1, &place, &variable);
  nc_def_var(file, "t", NC_DOUBLE, 1, &time, &variable);
  nc_put_att_text(file, NC_GLOBAL, "title", 3, "abc");
  nc_enddef(file);
  for (std::size_t record = 0; record < static_cast<std::size_t>(records); ++record) {
    const double value = 1;
    nc_put_var1_double(file, variable, &record, &value);
  }
  nc_close(file);
  return folder.read("w.nc");
}

TEST(NetcdfLength, is_missed_wherever_a_classic_file_is_cut_off_within_its_values) {
  const TemporaryFolder folder;
  for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA}) {
    for (const int records : {0, 1, 3}) {
      const std::string whole = bytes_of(folder, format, records);
      EXPECT_NO_THROW(require_whole_netcdf(folder.write("f.nc", whole))) << format;
      const std::size_t last_value = whole.size() - 1;
      const std::string cut = folder.write("f.nc", whole.substr(0, last_value));
      EXPECT_EQ(complaint_of([&] { require_whole_netcdf(cut); }),
                cut + ": is cut off: " + std::to_string(last_value) + " of its " +
                    std::to_string(whole.size()) + " bytes are there")
          << format << " " << records;
    }
  }
}

TEST(NetcdfLength, is_missed_wherever_the_header_is_cut_off) {
  const TemporaryFolder folder;
  const std::string whole = bytes_of(folder, 0, 1);
  const std::size_t header = whole.find("title") + 5;
  for (std::size_t length = 3; length < header; ++length) {
    const std::string cut = folder.write("f.nc", whole.substr(0, length));
    EXPECT_TRUE(
        complaint_of([&] { require_whole_netcdf(cut); }).starts_with(cut + ": is cut off: "))
        << length;
  }
}

/// A number of eight bytes, its largest first.
std::string eight(std::uint64_t number) {
  std::string bytes;
  for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xFFU);
  return bytes;
}

std::string four(std::uint64_t number) {
  return eight(number).substr(4);
}

const std::string no_list = four(0) + eight(0);
const std::string begin_of_64_bits = std::string("CDF\x05") + eight(0);

/// A header with one attribute of doubles, which says that it has so many.
std::string with_attribute(std::uint64_t values) {
  return begin_of_64_bits + no_list + four(12) + eight(1) + eight(0) + four(6) + eight(values) +
         no_list;
}

/// A header with a variable of bytes along dimensions of these lengths, which begins there.
std::string with_variable(std::uint64_t length, std::uint64_t other, std::uint64_t begin) {
  return begin_of_64_bits + four(10) + eight(2) + eight(0) + eight(length) + eight(0) +
         eight(other) + no_list + four(11) + eight(1) + eight(0) + eight(2) + eight(0) + eight(1) +
         no_list + four(1) + eight(0) + eight(begin);
}

TEST(NetcdfLength, is_missed_where_a_header_says_more_than_numbers_of_64_bits_hold) {
  const TemporaryFolder folder;
  const auto complaint = [&](const std::string& bytes) {
    const std::string file = folder.write("f.nc", bytes);
    return complaint_of([&] { require_whole_netcdf(file); }).substr(file.size());
  };
  const std::string broken = ": is cut off: its header is not whole";
  constexpr std::uint64_t two_to_32 = std::uint64_t{1} << 32U;
  EXPECT_EQ(complaint(with_attribute(std::uint64_t{1} << 61U)), broken) << "0 bytes, if it wraps";
  EXPECT_EQ(complaint(with_attribute((std::uint64_t{1} << 61U) - 3)), broken) << "back, if it does";
  EXPECT_EQ(complaint(with_variable(two_to_32, two_to_32, 0)), broken);
  EXPECT_EQ(complaint(with_variable(1, 1, ~std::uint64_t{0})), broken);
  EXPECT_EQ(complaint(with_variable(1, 1, 1000)), ": is cut off: 144 of its 1001 bytes are there");
  EXPECT_NO_THROW(require_whole_netcdf(folder.write("f.nc", with_variable(1, 1, 100))));
}

TEST(NetcdfLength, is_not_asked_of_other_files) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(require_whole_netcdf(folder.write("f.csv", "id,x,y\n")));
  EXPECT_NO_THROW(require_whole_netcdf(folder.write("empty", "")));
  EXPECT_NO_THROW(require_whole_netcdf(folder.write("f.nc", "\x89HDF\r\n\x1a\n")));
}

}  // namespace
}  // namespace thiessen
