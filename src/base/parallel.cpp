#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "base/interrupt.h"

namespace thiessen {

unsigned available_threads() {
  return std::max(1u, std::thread::hardware_concurrency());
}

bool can_start_threads(unsigned count) {
  std::atomic<bool> is_over{false};
  std::vector<std::thread> started;
  try {
    started.reserve(count);
    while (started.size() < count) started.emplace_back([&] { is_over.wait(false); });
  } catch (const std::system_error&) {  // those that have started tell how many can be had
  } catch (const std::bad_alloc&) {
  }
  is_over = true;
  is_over.notify_all();
  for (std::thread& thread : started) thread.join();
  return started.size() == count;
}

void in_parallel(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t, std::size_t)>& work) {
  const std::size_t workers = std::min<std::size_t>(std::max(1u, threads), count);
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::size_t failed_at = count;
  std::mutex failure_mutex;
  const auto run = [&](std::size_t worker) {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        throw_if_interrupted();
        work(worker, i);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (i < failed_at) {
          failure = std::current_exception();
          failed_at = i;
        }
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  others.reserve(workers);
  try {
    for (std::size_t worker = 1; worker < workers; ++worker) others.emplace_back(run, worker);
  } catch (const std::system_error&) {  // no more threads can start: those there do the work
  } catch (const std::bad_alloc&) {     // nor is there memory for more
  }
  if (workers > 0) run(0);
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

void side_by_side(const std::function<void()>& other, const std::function<void()>& own) {
  std::future<void> running;
  try {
    running = std::async(std::launch::async, other);
  } catch (const std::system_error&) {  // no further thread can be had
  } catch (const std::bad_alloc&) {
  }
  if (!running.valid()) other();
  own();
  if (running.valid()) running.get();
}

}  // namespace thiessen
