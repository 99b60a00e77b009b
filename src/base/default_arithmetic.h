#pragma once

#include <cfenv>

namespace thiessen {

/// Has the thread compute as C++ does unless told otherwise for as long as the object lives:
/// rounding to the nearest, keeping subnormal numbers, and without traps. A caller may have set
/// another mode for work of its own; numbers would then be read, and signs decided, wrong. Threads
/// that are begun meanwhile compute so, too. Afterwards all is as the caller had it.
class DefaultArithmetic {
 public:
  DefaultArithmetic() {
    std::fegetenv(&before_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultArithmetic() { std::fesetenv(&before_); }
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

 private:
  std::fenv_t before_{};
};

}  // namespace thiessen
