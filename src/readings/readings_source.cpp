#include "readings/readings_source.h"

namespace thiessen {

bool ReadingsSource::next(Row& row) {
  if (has_failed) return false;
  try {
    return table->next(row);
  } catch (const Error& error) {
    findings.complaints().add(error);
    return false;
  }
}

bool ReadingsSource::is_waiting(std::chrono::milliseconds at_most) {
  if (has_failed) return false;
  try {
    return table->is_waiting(at_most);
  } catch (const Error& error) {
    findings.complaints().add(error);
    has_failed = true;
    return false;
  }
}

bool ReadingsSource::gives_up() {
  return !findings.complaints().empty() && is_waiting(patience.left());
}

}  // namespace thiessen
