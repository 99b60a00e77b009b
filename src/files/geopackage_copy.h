#pragma once

#include <memory>
#include <string>

namespace thiessen {

/// A copy of a GeoPackage that is to be replaced by one with the same other layers. It keeps others
/// from writing to the file for as long as it lives, so that nothing of theirs is lost between the
/// copy and the replacement.
class GeoPackageCopy {
 public:
  /// Copies the file by SQLite's own backup. Where another program holds a lock on it, waits for it
  /// up to ten seconds; where the file has been replaced by then, the new one is copied. Throws
  /// Error where the lock lasts longer, where a log or a journal stands beside the file, and where
  /// it is damaged. Memory: twice the file's size.
  explicit GeoPackageCopy(const std::string& path);
  ~GeoPackageCopy();
  GeoPackageCopy(const GeoPackageCopy&) = delete;
  GeoPackageCopy& operator=(const GeoPackageCopy&) = delete;

  const std::string& bytes() const { return bytes_; }

 private:
  struct Lock;
  std::unique_ptr<Lock> lock_;
  std::string bytes_;
};

/// The copy of a file whose other layers are to be kept; null where it is not there, or no SQLite
/// database and so no GeoPackage. Throws Error, as GeoPackageCopy does, and where a journal or log
/// stands beside a file that is not there, which would be taken for the new one's.
std::unique_ptr<GeoPackageCopy> copy_of_geopackage(const std::string& path);

}  // namespace thiessen
