// Long work for a caller who may press Ctrl-C and wants to know how far it is.
//
// The study runs on a thread of its own, without the interpreter's lock; the caller's thread looks
// for signals and passes on the progress, some ten times a second, since only there Python hears
// either.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "studies/study_supervision.hpp"

namespace reeve::python {

namespace py = pybind11;

class Watch {
 public:
  studies::StudySupervision supervision() {
    return {[this](const std::string& stage, const search::Progress& progress) {
              const std::scoped_lock lock(mutex_);
              stage_ = stage;
              progress_ = progress;
            },
            &stop_};
  }

  void stop() { stop_.store(true); }

  // Passes the last report to a function of stage, done and total.
  void tell(const py::object& listener) {
    std::string stage;
    search::Progress progress;
    {
      const std::scoped_lock lock(mutex_);
      stage = stage_;
      progress = progress_;
    }
    if (!listener.is_none() && !stage.empty()) listener(stage, progress.done, progress.total);
  }

 private:
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::string stage_;
  search::Progress progress_;
};

// The result, and whether Ctrl-C stopped it. Whatever else a signal's handler or the listener
// raises stops it too, and is raised again once the study has ended.
template <typename Study>
auto watched(const py::object& listener, Study study) {
  constexpr auto pause = std::chrono::milliseconds(100);
  Watch watch;
  bool interrupted = false;
  std::optional<py::error_already_set> raised;
  auto result = std::async(std::launch::async, [&] { return study(watch.supervision()); });
  const auto ready = [&] {
    const py::gil_scoped_release release;
    return result.wait_for(pause) == std::future_status::ready;
  };
  while (!ready()) {
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!raised && !interrupted) watch.tell(listener);
    } catch (py::error_already_set& error) {
      watch.stop();
      if (error.matches(PyExc_KeyboardInterrupt)) {
        interrupted = true;
      } else {
        raised.emplace(error);
      }
    }
  }
  if (raised) {
    const py::gil_scoped_release release;
    result.wait();
  }
  if (raised) throw py::error_already_set(*raised);
  return std::pair(result.get(), interrupted);
}

}  // namespace reeve::python
