#include "files/netcdf_writer.h"

#include <H5public.h>
#include <netcdf.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.h"

namespace thiessen {
namespace {

constexpr int whole_file = NC_GLOBAL;

/// Whether the system gives this reason for a failed write. The library has one for all of them.
bool is_of_disk(int why) {
  return why == ENOSPC || why == EFBIG || why == EDQUOT || why == EIO;
}

}  // namespace

NetcdfWriter::NetcdfWriter(const std::string& file, std::string name) : name_(std::move(name)) {
  // Where the disk was full, HDF5 would crash as the program ends: it tries to close the file
  // again.
  H5dont_atexit();
  check(nc_create(file.c_str(), NC_NETCDF4 | NC_NOCLOBBER, &file_));
}

NetcdfWriter::~NetcdfWriter() {
  if (file_ >= 0) nc_close(file_);
}

void NetcdfWriter::check(int status) const {
  if (status == NC_NOERR) return;
  const int why = errno;
  throw Error(Message{name_, 0,
                      std::string("cannot be written: ") +
                          (is_of_disk(why) ? std::strerror(why) : nc_strerror(status)),
                      ""});
}

int NetcdfWriter::dimension(const char* name, std::size_t length) {
  int made = -1;
  check(nc_def_dim(file_, name, length, &made));
  return made;
}

int NetcdfWriter::variable(const char* name, int type, std::span<const int> dimensions) {
  int made = -1;
  check(
      nc_def_var(file_, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &made));
  return made;
}

void NetcdfWriter::put_text(int variable, const char* name, const std::string& text) {
  check(nc_put_att_text(file_, variable, name, text.size(), text.data()));
}

void NetcdfWriter::put_origin(const Provenance& made_by) {
  put_text(whole_file, "Conventions", "CF-1.8");
  put_text(whole_file, "source", made_by.software);
  for (const auto& [name, value] : items_of(made_by)) put_text(whole_file, name.c_str(), value);
}

void NetcdfWriter::close() {
  const int file = file_;
  file_ = -1;
  check(nc_close(file));
}

const char* time_method_of(const std::string& unit) {
  const bool is_rate = unit.find('/') != std::string::npos ||
                       unit.find(" per ") != std::string::npos ||
                       unit.find("-1") != std::string::npos;
  return is_rate ? "time: mean" : "time: sum";
}

}  // namespace thiessen
