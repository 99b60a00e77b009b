#pragma once

#include <string>

#include "base/file.h"
#include "rainfall/findings/reading_finding.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// Writes readings that cannot be true as CSV, `station,time,finding,value,expected`, a row each:
/// see ReadingFinding. The time is empty where the whole gauge is meant, and what is expected where
/// it is not known. Numbers have the fewest digits that read back to the same double.
class FindingsFile {
 public:
  /// Both must outlive this object.
  FindingsFile(OutputFile& file, const Network& network);

  void add(const ReadingFinding& finding);

 private:
  OutputFile& file_;
  const Network& network_;
  std::string row_;
};

}  // namespace thiessen
