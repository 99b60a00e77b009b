// Compiled alone: it replaces the program's operator new with names of its own.
// Every allocation of a commit fails once, the n-th for every n: all files are old, or all new.
#include <gtest/gtest.h>

#include <map>
#include <new>
#include <string>

#include "base/failing_allocations.h"
#include "base/outputs.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using Contents = std::map<std::string, std::string>;

const Contents old_files = {{"a.csv", "old"}, {"b.csv", "old"}, {"b.qix", "old"}, {"b.sbn", "old"}};
const Contents new_files = {{"a.csv", "new"}, {"b.csv", "new"}, {"c.csv", "new"}};

Contents contents_of(const TemporaryFolder& folder) {
  Contents found;
  for (const std::string& name : folder.names()) found[name] = folder.read(name);
  return found;
}

/// Whether the outputs were committed while the n-th allocation failed, or fewer were made.
bool commit_without(long allocation, const TemporaryFolder& folder) {
  Outputs outputs({true, {}});
  for (const auto& [name, text] : new_files) outputs.add(folder.path(name)).append(text);
  for (const char* const side_file : {"b.qix", "b.sbn"}) outputs.remove(folder.path(side_file));
  left = allocation;
  try {
    outputs.commit();
  } catch (const std::bad_alloc&) {
    return false;
  }
  return true;
}

TEST(OutputsOutOfMemory, are_all_old_or_all_new) {
  long failed = 0;
  bool is_through = false;
  for (long allocation = 1; !is_through; ++allocation) {
    const TemporaryFolder folder;
    for (const auto& [name, text] : old_files) folder.write(name, text);
    const bool is_done = commit_without(allocation, folder);
    is_through = left > 0;
    left = -1;
    failed += is_done ? 0 : 1;
    ASSERT_EQ(contents_of(folder), is_done ? new_files : old_files) << allocation;
  }
  EXPECT_GT(failed, 10);
}

}  // namespace
}  // namespace thiessen
