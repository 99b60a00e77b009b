#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// Keeps GDAL's messages to itself for as long as it lives, on this thread: nothing is printed.
class GdalErrors {
 public:
  GdalErrors();
  ~GdalErrors();
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  bool failed() const { return failed_; }
  /// The first error, else the first warning; on one line, without a full stop.
  std::string text() const;
  const std::string& first_warning() const { return warning_; }
  void clear();
  /// Called by GDAL.
  void hear(bool error, const char* message);

 private:
  bool failed_ = false;
  std::string error_;
  std::string warning_;
};

}  // namespace thiessen
