#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"

namespace thiessen {

/// The sentences of the Error that the call throws, each with its hint; fails the test where there
/// is none.
template <typename Call>
std::vector<std::string> complaints_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    std::vector<std::string> sentences;
    for (const Message& message : error.messages()) {
      const std::string hint = message.hint.plain();
      sentences.push_back(message.sentence() + (hint.empty() ? "" : " | " + hint));
    }
    return sentences;
  }
  ADD_FAILURE() << "no Error was thrown";
  return {"", "", ""};
}

/// The first of them.
template <typename Call>
std::string complaint_of(Call call) {
  return complaints_of(call).at(0);
}

inline std::vector<std::string> sentences_of(const Warnings& warnings) {
  std::vector<std::string> sentences;
  for (const Message& message : warnings.messages()) sentences.push_back(message.sentence());
  return sentences;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace thiessen
