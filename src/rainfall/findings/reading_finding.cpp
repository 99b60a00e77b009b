#include "rainfall/findings/reading_finding.h"

namespace thiessen {

const char* name_of(FindingKind kind) {
  switch (kind) {
    case FindingKind::spike:
      return "spike";
    case FindingKind::zero:
      return "zero";
    case FindingKind::stuck:
      return "stuck";
    case FindingKind::unit:
      return "unit";
    case FindingKind::shift:
      return "shift";
    case FindingKind::jump:
      return "break";
  }
  return "";
}

}  // namespace thiessen
