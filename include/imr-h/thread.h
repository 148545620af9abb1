#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>

namespace imr {
namespace concurrent {

/// Mutual exclusion; not recursive.
typedef std::mutex Mutex;
/// Holds a Mutex for the length of a block: `ScopedLock lk(mtx);` (thesis C.2 l.90, 276).
typedef std::unique_lock<std::mutex> ScopedLock;
/// Lets threads wait for each other: wait(lk), notify_one(), notify_all().
typedef std::condition_variable Condition;

/// A thread as an object: a class derives from it, writes what the thread does in threadBody(), and
/// how to end it in stop() (thesis C.1 l.19-30).
///
/// Life: execute() starts the thread, which runs threadBody() once; stop() asks it to end; join()
/// waits until it has. All public functions may be called from any thread, also several at once.
///
/// **The destructor of the derived class must call stop() and then join()**, as the course's
/// programs do (thesis C.2 l.75-76): when CThread's own destructor runs, the members that
/// threadBody() uses are gone, and stop() can no longer be called. A destructor of CThread that
/// still finds its thread running logs a warning and waits for threadBody() to return by itself;
/// the program is neither crashed nor terminated for it.
class CThread {
 public:
  typedef concurrent::Mutex Mutex;
  typedef concurrent::ScopedLock ScopedLock;
  typedef concurrent::Condition Condition;

  /// Starts nothing yet.
  CThread();

  /// See the class comment. Destroying the object from inside its own threadBody() is allowed.
  virtual ~CThread();

  CThread(const CThread&) = delete;
  CThread& operator=(const CThread&) = delete;

  /// Starts the thread. After it has finished it may be started again.
  /// Throws bad_usage if it is running, and imr::exception if the system has no thread to give.
  void execute();

  /// Waits until threadBody() has returned. Returns at once if the thread was never started, has
  /// been joined already, or is the caller itself.
  void join();

  /// Whether the thread was started and threadBody() has not returned yet.
  bool isRunning() const;

  /// Whether threadBody() has returned, or was left by an exception, since the last execute().
  bool isFinished() const;

  /// Lets another thread of the computer run first.
  void yield();

  /// Asks threadBody() to return soon, and does not wait for it. Written by the derived class; it
  /// must be safe to call at any time, also before execute() and more than once.
  virtual void stop() = 0;

 protected:
  /// What the thread does. An exception that leaves it ends only this thread: it is caught and
  /// logged with ERROR.
  virtual void threadBody() = 0;

 private:
  struct SState;
  // Shared with the running thread, which may outlive this object for a moment.
  const std::shared_ptr<SState> state_;
};

}  // namespace concurrent
}  // namespace imr
