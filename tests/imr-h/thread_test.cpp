#include "imr-h/thread.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <chrono>
#include <functional>
#include <future>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "imr-h/imr_exceptions.h"

namespace {

using imr::concurrent::CThread;

// A thread as the course writes them: waits until somebody stops it, and counts its runs.
class Waiter : public CThread {
 public:
  ~Waiter() override {
    stop();
    join();
  }
  void stop() override {
    ScopedLock lk(mtx_);
    quit_ = true;
    changed_.notify_all();
  }
  void Rearm() {
    ScopedLock lk(mtx_);
    quit_ = false;
  }
  int Runs() {
    ScopedLock lk(mtx_);
    return runs_;
  }

 protected:
  void threadBody() override {
    ScopedLock lk(mtx_);
    ++runs_;
    while (!quit_) changed_.wait(lk);
  }

 private:
  Mutex mtx_;
  Condition changed_;
  bool quit_ = false;
  int runs_ = 0;
};

// Runs a function given to it. Its destructor leaves out stop() and join() when told to.
class Runner : public CThread {
 public:
  explicit Runner(std::function<void(Runner&)> body, bool forgets_join = false)
      : body_(std::move(body)), forgets_join_(forgets_join) {}
  ~Runner() override {
    if (!forgets_join_) join();
  }
  void stop() override {}

 protected:
  void threadBody() override { body_(*this); }

 private:
  std::function<void(Runner&)> body_;
  bool forgets_join_;
};

// Standard output while the object lives.
class Captured {
 public:
  Captured() : old_(std::cout.rdbuf(text_.rdbuf())) {}
  ~Captured() { std::cout.rdbuf(old_); }
  std::string Text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::streambuf* old_;
};

// Has threadBody() and stop() in the same places as the class of the thesis.
template <typename T, typename = void>
struct HasPublicThreadBody : std::false_type {};
template <typename T>
struct HasPublicThreadBody<T, std::void_t<decltype(std::declval<T&>().threadBody())>>
    : std::true_type {};

}  // namespace

TEST(X05, ThreadOffersWhatTheListingUses) {
  static_assert(std::is_abstract_v<CThread>);
  static_assert(std::has_virtual_destructor_v<CThread>);
  static_assert(!HasPublicThreadBody<CThread>::value);
  static_assert(std::is_same_v<CThread::Mutex, imr::concurrent::Mutex>);
  static_assert(std::is_constructible_v<CThread::ScopedLock, CThread::Mutex&>);
  static_assert(std::is_same_v<CThread::Condition, imr::concurrent::Condition>);
  Waiter waiter;
  EXPECT_FALSE(waiter.isRunning());
  EXPECT_FALSE(waiter.isFinished());
  waiter.execute();
  EXPECT_TRUE(waiter.isRunning());
  EXPECT_FALSE(waiter.isFinished());
  waiter.yield();
  waiter.stop();
  waiter.join();
  EXPECT_FALSE(waiter.isRunning());
  EXPECT_TRUE(waiter.isFinished());
  EXPECT_EQ(waiter.Runs(), 1);
}

TEST(X05, JoinReturnsWithoutAThreadAndWhenRepeated) {
  Waiter waiter;
  waiter.join();
  waiter.execute();
  waiter.stop();
  waiter.join();
  waiter.join();
  EXPECT_TRUE(waiter.isFinished());
}

TEST(X05, BodyRunsInAnotherThread) {
  std::thread::id id;
  Runner runner([&](Runner&) { id = std::this_thread::get_id(); });
  runner.execute();
  runner.join();
  EXPECT_NE(id, std::this_thread::get_id());
  EXPECT_NE(id, std::thread::id());
}

TEST(ImrThread, StopBeforeExecuteIsKept) {
  Waiter waiter;
  waiter.stop();
  waiter.execute();
  waiter.join();
  EXPECT_EQ(waiter.Runs(), 1);
}

TEST(ImrThread, SecondExecuteIsRefusedWhileItRuns) {
  Waiter waiter;
  waiter.execute();
  EXPECT_THROW(waiter.execute(), imr::bad_usage);
  EXPECT_TRUE(waiter.isRunning());
}

TEST(ImrThread, CanRunAgainAfterItHasFinished) {
  Waiter waiter;
  for (int i = 1; i <= 3; ++i) {
    waiter.Rearm();
    waiter.execute();
    waiter.stop();
    // The second round starts again without a join.
    if (i == 2) {
      while (!waiter.isFinished()) std::this_thread::yield();
    } else {
      waiter.join();
    }
    EXPECT_EQ(waiter.Runs(), i);
  }
}

TEST(ImrThread, ManyMayJoinAtOnce) {
  for (int round = 0; round < 20; ++round) {
    Waiter waiter;
    waiter.execute();
    std::vector<std::thread> others;
    for (int i = 0; i < 4; ++i) {
      others.emplace_back([&] {
        waiter.join();
        EXPECT_TRUE(waiter.isFinished());
      });
    }
    waiter.stop();
    for (std::thread& other : others) other.join();
  }
}

TEST(ImrThread, ExceptionEndsOnlyTheThreadAndIsLogged) {
  struct Strange {};
  Captured captured;
  Runner standard([](Runner&) { throw std::runtime_error("the map is empty"); });
  standard.execute();
  standard.join();
  EXPECT_TRUE(standard.isFinished());
  Runner strange([](Runner&) { throw Strange(); });
  strange.execute();
  strange.join();
  const std::string text = captured.Text();
  EXPECT_NE(text.find("ERROR: an exception has ended a thread: the map is empty\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("Strange has ended a thread\n"), std::string::npos) << text;
}

TEST(ImrThread, PthreadExitEndsTheThreadQuietly) {
  Captured captured;
  Runner runner([](Runner&) { pthread_exit(nullptr); });
  runner.execute();
  runner.join();
  EXPECT_TRUE(runner.isFinished());
  EXPECT_EQ(captured.Text(), "");
}

TEST(ImrThread, JoinFromInsideReturns) {
  bool passed = false;
  Runner runner([&](Runner& self) {
    self.join();
    passed = true;
  });
  runner.execute();
  runner.join();
  EXPECT_TRUE(passed);
}

TEST(ImrThread, DestructorWaitsWhenJoinWasForgotten) {
  // The body uses nothing of the object after it has begun, as the destroyed members would be gone.
  auto begun = std::make_shared<std::promise<void>>();
  auto ended = std::make_shared<std::promise<void>>();
  std::future<void> end = ended->get_future();
  Captured captured;
  {
    Runner runner(
        [begun, ended](Runner&) {
          // Copies: the closure itself dies with the object.
          const auto mine = ended;
          begun->set_value();
          std::this_thread::sleep_for(std::chrono::milliseconds(50));
          mine->set_value();
        },
        true);
    runner.execute();
    begun->get_future().wait();
  }
  EXPECT_EQ(end.wait_for(std::chrono::seconds(0)), std::future_status::ready);
  EXPECT_NE(captured.Text().find("WARN: a CThread is destroyed while its thread is running"),
            std::string::npos);
}

TEST(ImrThread, MayDestroyItselfFromInside) {
  class SelfDestroying : public CThread {
   public:
    explicit SelfDestroying(std::promise<void> gone) : gone_(std::move(gone)) {}
    ~SelfDestroying() override { gone_.set_value(); }
    void stop() override {}

   protected:
    void threadBody() override { delete this; }

   private:
    std::promise<void> gone_;
  };
  std::promise<void> gone;
  std::future<void> future = gone.get_future();
  (new SelfDestroying(std::move(gone)))->execute();
  EXPECT_EQ(future.wait_for(std::chrono::seconds(10)), std::future_status::ready);
  // The thread still has to leave; give sanitizers time to see it.
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
}
