#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "results/provenance.h"

namespace thiessen {

/// A NetCDF-4 file that is being written. What the library refuses is an Error, which gives the
/// system's reason where there is one.
class NetcdfWriter {
 public:
  /// Begins the file. `file` is where it is written, `name` what messages call it.
  NetcdfWriter(const std::string& file, std::string name);
  ~NetcdfWriter();
  NetcdfWriter(const NetcdfWriter&) = delete;
  NetcdfWriter& operator=(const NetcdfWriter&) = delete;

  int file() const { return file_; }
  /// Throws Error where a function of the library has failed.
  void check(int status) const;
  int dimension(const char* name, std::size_t length);
  int variable(const char* name, int type, std::span<const int> dimensions);
  void put_text(int variable, const char* name, const std::string& text);
  /// Says by which conventions the file is written, and by what it was made.
  void put_origin(const Provenance& made_by);
  /// Ends the file.
  void close();

 private:
  std::string name_;
  int file_ = -1;
};

/// What the rainfall of a step is of its time, as CF's cell methods say it: a sum, but of a rate
/// such as mm/h a mean.
const char* time_method_of(const std::string& unit);

}  // namespace thiessen
