#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace ccmorse::sim {

/// A fixed number of threads that share a piece of work in fixed parts, so that who does what does
/// not depend on who is faster (design: Determinism). One thread at a time may call Run(), and it
/// does a part itself.
class WorkerPool {
 public:
  /// `threads` >= 1, the caller's own included.
  explicit WorkerPool(int threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  int threads() const { return static_cast<int>(workers_.size()) + 1; }

  /// Calls work(part) once for each part from 0 to threads() - 1, each in a thread of its own, and
  /// returns when all are done. `work` does not throw.
  template <typename Work>
  void Run(const Work& work) {
    RunParts(
        {[](const void* object, int part) { (*static_cast<const Work*>(object))(part); }, &work});
  }

 private:
  struct Task {
    void (*call)(const void*, int) = nullptr;
    const void* object = nullptr;
  };
  void RunParts(const Task& task);
  void Serve(int part);

  Task task_;
  std::atomic<std::uint32_t> round_ = 0;    // counts Run() calls; the lowest bit: stop
  std::atomic<std::uint32_t> working_ = 0;  // workers that have not finished the round
  std::vector<std::thread> workers_;
};

}  // namespace ccmorse::sim
