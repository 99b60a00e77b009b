#include "files/rainfall/files_without_rain.h"

#include "base/enumeration.h"
#include "files/rainfall/published_rainfall.h"

namespace thiessen {

JoinedReadings::Opened FilesWithoutRain::open_next(const Open& open, const std::string& file,
                                                   Warnings& warnings) {
  ++opened_;
  JoinedReadings::Opened opened;
  try {
    opened = open(warnings);
  } catch (const NoRain& none) {
    warnings.have_been_told();  // how a file is written that is not read
    passed_over_.push_back(file);
    for (const Message& message : none.messages()) faults_.add(message);
    if (passed_over_.size() == count_) fail();
  }
  if (opened_ == count_ && !passed_over_.empty()) tell(warnings);
  return opened;
}

/// Throws what was said of each file.
void FilesWithoutRain::fail() {
  try {
    faults_.throw_if_any();
  } catch (const Error& error) {
    throw NoRain(error.messages(), error.unlisted());
  }
}

void FilesWithoutRain::tell(Warnings& warnings) const {
  constexpr std::size_t most = 5;
  std::string text = passed_over_.size() == 1 ? "a file without rain is" : "files without rain are";
  text += " passed over: " + enumerated_up_to(most, passed_over_);
  warnings.add_notice({name_, 0, std::move(text), ""});
}

}  // namespace thiessen
