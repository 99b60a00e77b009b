#pragma once

#include <functional>
#include <string>

#include "base/error.h"

namespace thiessen {

/// What the Error that is thrown says, or that none is.
inline std::string sentence_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace thiessen
