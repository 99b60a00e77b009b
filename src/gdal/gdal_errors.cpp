#include "gdal/gdal_errors.h"

#include <cpl_error.h>

#include <algorithm>
#include <utility>

namespace thiessen {
namespace {

void CPL_STDCALL keep(CPLErr severity, CPLErrorNum, const char* message) {
  auto* errors = static_cast<GdalErrors*>(CPLGetErrorHandlerUserData());
  if (severity == CE_Failure || severity == CE_Fatal) errors->hear(true, message);
  if (severity == CE_Warning) errors->hear(false, message);
}

std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  return text;
}

}  // namespace

GdalErrors::GdalErrors() {
  CPLPushErrorHandlerEx(keep, this);
}

GdalErrors::~GdalErrors() {
  CPLPopErrorHandler();
  CPLErrorReset();
}

std::string GdalErrors::text() const {
  if (!error_.empty()) return error_;
  return warnings_.empty() ? "GDAL gives no reason" : warnings_.front();
}

void GdalErrors::clear() {
  failed_ = false;
  error_.clear();
  warnings_.clear();
}

void GdalErrors::hear(bool error, const char* message) {
  failed_ = failed_ || error;
  std::string text = on_one_line(message);
  if (error) {
    if (error_.empty()) error_ = std::move(text);
  } else if (warnings_.size() < most_warnings &&
             std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end()) {
    warnings_.push_back(std::move(text));
  }
}

}  // namespace thiessen
