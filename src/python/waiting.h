#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <system_error>

#include "base/interrupt.h"
#include "python/progress.h"

namespace thiessen::python {

/// Does the work on a thread of its own, without the interpreter's lock, while this one hears
/// Ctrl-C and tells the caller's function how far it is. What either of them throws ends the work.
template <typename Work>
void wait_for(const Work& work, const Progress& progress, const pybind11::object& told) {
  constexpr auto pause = std::chrono::milliseconds(50);
  std::future<void> running;
  {
    const pybind11::gil_scoped_release released;
    try {
      running = std::async(std::launch::async, work);
    } catch (const std::system_error&) {  // no further thread can be had
      work();
      return;
    }
    while (running.wait_for(pause) != std::future_status::ready) {
      const pybind11::gil_scoped_acquire held;
      try {
        if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
        if (!told.is_none()) told(progress.done(), progress.total());
      } catch (const pybind11::error_already_set&) {
        ask_to_stop();
        {
          const pybind11::gil_scoped_release until_it_has_stopped;
          running.wait();
        }
        forget_interrupt();
        throw;
      }
    }
    running.get();
  }
  if (!told.is_none()) told(progress.done(), progress.total());
}

}  // namespace thiessen::python
