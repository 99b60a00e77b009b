#pragma once

#include <cstddef>
#include <functional>

namespace thiessen {

/// How many threads the machine runs at once; at least 1.
unsigned available_threads();

/// Whether so many threads more can be had at this moment. For libraries that wait for ever where a
/// thread of theirs cannot start.
bool can_start_threads(unsigned count);

/// Calls work(worker, i) once for every i below `count`, shared among up to `threads` workers
/// numbered from 0. Throws Interrupted where a signal came. Where calls throw, it rethrows one of
/// their exceptions once all workers have stopped.
void in_parallel(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t worker, std::size_t i)>& work);

/// Calls `other` on a thread of its own while this one calls `own`; where no thread can be had,
/// calls them here, `other` first, and `own` only if that throws nothing. What `own` throws comes
/// out, else what `other` throws, when both have ended.
void side_by_side(const std::function<void()>& other, const std::function<void()>& own);

}  // namespace thiessen
