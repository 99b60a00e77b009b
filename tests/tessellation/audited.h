#pragma once

namespace thiessen {

/// How often a test repeats a change: less often where each ends with an audit of the whole.
constexpr int often(int times) {
#ifdef THIESSEN_AUDIT
  return times / 50;
#else
  return times;
#endif
}

}  // namespace thiessen
