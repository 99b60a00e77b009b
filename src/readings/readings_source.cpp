#include "readings/readings_source.h"

namespace thiessen {

bool ReadingsSource::next(Row& row) {
  try {
    return table->next(row);
  } catch (const Error& error) {
    findings.complaints().add(error);
    return false;
  }
}

}  // namespace thiessen
