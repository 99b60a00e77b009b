#include "readings/folded_warnings.h"

#include <utility>

namespace thiessen {

void FoldedWarnings::add(const Warnings& of_file) {
  for (const Message& message : of_file.messages()) add(message, false);
  for (const Message& notice : of_file.notices()) add(notice, true);
}

void FoldedWarnings::add(const Message& message, bool is_notice) {
  const auto [place, is_new] =
      places_.emplace((is_notice ? "notice " : "warning ") + message.text.plain(), all_.size());
  if (is_new) {
    all_.push_back({message, is_notice, 0, message.file});
    return;
  }
  Folded& folded = all_[place->second];
  if (folded.last_file != message.file) ++folded.others;
  folded.last_file = message.file;
}

void FoldedWarnings::pass_on(Warnings& warnings) const {
  for (const Folded& folded : all_) {
    Message message = folded.first;
    if (folded.others > 0) {
      message.text += " (and the same of " + std::to_string(folded.others) +
                      (folded.others == 1 ? " more file)" : " more files)");
    }
    folded.is_notice ? warnings.add_notice(std::move(message)) : warnings.add(std::move(message));
  }
}

}  // namespace thiessen
