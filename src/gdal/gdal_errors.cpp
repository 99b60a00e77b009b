#include "gdal/gdal_errors.h"

#include <cpl_error.h>
#include <sqlite3.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <utility>

#include "base/memory.h"

namespace thiessen {
namespace {

std::atomic<void (*)() noexcept> end_of_program = nullptr;

/// Of some fatal lacks of memory GDAL has no number: its words tell them.
void end_where_fatal(CPLErr severity, CPLErrorNum number, const char* message) {
  const bool is_lack = number == CPLE_OutOfMemory || std::strstr(message, "emory") != nullptr;
  if (number == CPLE_OutOfMemory) note_lack_of_memory();
  const auto end = end_of_program.load();
  if (severity == CE_Fatal && is_lack && end != nullptr) end();
}

/// Where nobody listens, an error is told as GDAL tells it.
void CPL_STDCALL hear_alone(CPLErr severity, CPLErrorNum number, const char* message) {
  end_where_fatal(severity, number, message);
  CPLDefaultErrorHandler(severity, number, message);
}

void CPL_STDCALL keep(CPLErr severity, CPLErrorNum number, const char* message) {
  end_where_fatal(severity, number, message);
  auto* errors = static_cast<GdalErrors*>(CPLGetErrorHandlerUserData());
  if (severity == CE_Failure || severity == CE_Fatal) errors->hear(true, message);
  if (severity == CE_Failure && number == CPLE_FileIO) errors->note_of_file();
  if (severity == CE_Warning) errors->hear(false, message);
}

std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  // What a library of GDAL's caught tells its C++ name, and GDAL itself a line of its source.
  for (const char* words : {"std::bad_alloc", "annot allocate", "ut of memory"})
    if (text.find(words) != std::string::npos) {
      note_lack_of_memory();
      return "not enough memory";
    }
  return text;
}

/// SQLite tells its log of an allocation that failed. GDAL and PROJ call it, and tell its failure
/// as what they could not do.
void hear_sqlite(void*, int code, const char*) {
  if (code == SQLITE_NOMEM) note_lack_of_memory();
}

}  // namespace

void when_gdal_lacks_memory(void (*end)() noexcept) {
  end_of_program = end;
  sqlite3_config(SQLITE_CONFIG_LOG, hear_sqlite,
                 nullptr);  // in vain where SQLite is in use already
  CPLSetErrorHandler(hear_alone);
  CPLErrorReset();  // makes what GDAL keeps of errors, for which there may be no memory later
}

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
  failed_to_read_ = false;
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
