#pragma once

namespace thiessen {

/// Fixes the date that GDAL writes for as long as it lives, so that the same input makes the same
/// bytes on any day.
class FixedDate {
 public:
  FixedDate();
  ~FixedDate();
  FixedDate(const FixedDate&) = delete;
  FixedDate& operator=(const FixedDate&) = delete;
};

}  // namespace thiessen
