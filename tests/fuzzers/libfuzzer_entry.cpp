// What libFuzzer calls. THIESSEN_FUZZER names the one of fuzzers.h that this program is.
#include <cstddef>
#include <cstdint>

#include "fuzzers/fuzzers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  thiessen::fuzzers::THIESSEN_FUZZER({bytes, count});
  return 0;
}
