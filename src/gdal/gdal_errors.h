#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace thiessen {

/// What is called where GDAL is about to end the program, as it does where it lacks memory. Without
/// it the program is aborted. From then on a lack of memory in GDAL and in SQLite is noted
/// (base/memory) where they go on.
void when_gdal_lacks_memory(void (*end)() noexcept);

/// Catches GDAL's messages on this thread for as long as it lives, so that nothing is printed.
class GdalErrors {
 public:
  GdalErrors();
  ~GdalErrors();
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  bool failed() const { return failed_; }
  /// Whether one of the errors was of bytes that a file should have.
  bool failed_to_read() const { return failed_to_read_; }
  /// The first error, or the first warning where there is no error; on one line, without a full
  /// stop.
  std::string text() const;
  /// The warnings in their order, each once and on one line; the first `most_warnings` of them.
  const std::vector<std::string>& warnings() const { return warnings_; }
  static constexpr std::size_t most_warnings = 20;
  void clear();
  /// Takes a message; GDAL calls it.
  void hear(bool error, const char* message);
  /// Notes that the error heard last was of a file's bytes; GDAL calls it.
  void note_of_file() { failed_to_read_ = true; }

 private:
  bool failed_ = false;
  bool failed_to_read_ = false;
  std::string error_;
  std::vector<std::string> warnings_;
};

}  // namespace thiessen
