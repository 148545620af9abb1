#include "imr-h/thread.h"

#include <cxxabi.h>

#include <cstdlib>
#include <exception>
#include <string>
#include <system_error>
#include <thread>
#include <typeinfo>
#include <utility>

#include "imr-h/imr_exceptions.h"
#include "imr-h/logging.h"

namespace imr {
namespace concurrent {
namespace {

// The type of the exception that is being handled, for one that carries no message we know of.
std::string currentExceptionType() {
  const std::type_info* type = abi::__cxa_current_exception_type();
  if (type == nullptr) return "of unknown type";
  int status = 0;
  char* readable = abi::__cxa_demangle(type->name(), nullptr, nullptr, &status);
  const std::string name = status == 0 ? readable : type->name();
  std::free(readable);
  return "of type " + name;
}

}  // namespace

struct CThread::SState {
  std::mutex mutex;
  std::condition_variable finished;  // signalled when phase becomes kFinished
  enum { kIdle, kRunning, kFinished } phase = kIdle;
  bool abandoned = false;     // the object is being destroyed: threadBody() must not be called
  std::thread thread;         // joinable until somebody joins it
  std::thread::id thread_id;  // the running thread, while phase is kRunning
};

CThread::CThread() : state_(std::make_shared<SState>()) {}

CThread::~CThread() {
  bool own_thread = false;
  bool running = false;
  {
    const ScopedLock lock(state_->mutex);
    state_->abandoned = true;
    running = state_->phase == SState::kRunning;
    own_thread = running && state_->thread_id == std::this_thread::get_id();
    // A thread that destroys its own object cannot wait for itself.
    if (own_thread && state_->thread.joinable()) state_->thread.detach();
  }
  if (running && !own_thread) {
    WARN(
        "a CThread is destroyed while its thread is running; "
        "the destructor of the derived class should call stop() and join()");
  }
  join();
}

void CThread::execute() {
  std::thread previous;
  {
    const ScopedLock lock(state_->mutex);
    assert_usage(state_->phase != SState::kRunning, "CThread::execute(): already running");
    previous.swap(state_->thread);
    state_->phase = SState::kRunning;
    try {
      // The new thread waits for this lock first, so that it finds its own id stored.
      state_->thread = std::thread([this, state = state_] {
        bool run = false;
        {
          const ScopedLock start(state->mutex);
          run = !state->abandoned;
        }
        // Marks the end also when pthread_exit() unwinds this function.
        struct SFinisher {
          SState& state;
          ~SFinisher() {
            const ScopedLock end(state.mutex);
            state.phase = SState::kFinished;
            state.finished.notify_all();
          }
        } finisher{*state};
        if (!run) return;
        try {
          threadBody();
        } catch (const std::exception& e) {
          ERROR("an exception has ended a thread: " << e.what());
        } catch (...) {
          // No C++ exception: pthread_exit() or a cancelled thread, which must go on unwinding.
          if (std::current_exception() == nullptr) throw;
          ERROR("an exception " << currentExceptionType() << " has ended a thread");
        }
      });
      state_->thread_id = state_->thread.get_id();
    } catch (const std::system_error& e) {
      state_->phase = SState::kFinished;
      state_->thread.swap(previous);
      throw exception(std::string("cannot start a thread: ") + e.what());
    }
  }
  if (previous.joinable()) previous.join();
}

void CThread::join() {
  std::thread ended;
  {
    ScopedLock lock(state_->mutex);
    if (state_->phase == SState::kRunning && state_->thread_id == std::this_thread::get_id()) {
      return;
    }
    state_->finished.wait(lock, [this] { return state_->phase != SState::kRunning; });
    // Of several callers the first one takes the thread; for the others it has finished, too.
    ended.swap(state_->thread);
  }
  if (ended.joinable()) ended.join();
}

bool CThread::isRunning() const {
  const ScopedLock lock(state_->mutex);
  return state_->phase == SState::kRunning;
}

bool CThread::isFinished() const {
  const ScopedLock lock(state_->mutex);
  return state_->phase == SState::kFinished;
}

void CThread::yield() { std::this_thread::yield(); }

}  // namespace concurrent
}  // namespace imr
