// What the readers of a stream may not do to a run by the clock: a slow reader never delays a tick,
// nor does one that reads, and each line is what it is without them.
//
// Two things are measured of each tick, with readers and without by turns in one run, so that what
// else the machine does falls on both: the processor time that the run's thread takes for it, which
// other programs hardly change, and how late it is by the clock.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/servers/served_simulation.h"
#include "tests/support/line_client.h"

namespace ccmorse::servers {
namespace {

using testing::LineClient;

constexpr int kReadersOfAScan = 8;
constexpr int kRoundsOfReaders = 7;
constexpr std::size_t kPhasesOfReaders = 14;       // without and with them, in turn
constexpr double kTickOfReaders = 1.0 / 60.0;      // s
constexpr double kMostProcessorTimeMore = 0.5e-3;  // s a tick; a line in the loop takes 2 to 4 ms
constexpr double kMostLateness = kTickOfReaders;   // s more, at the median
// Lines of 340 kB, a tick each.
constexpr const char* kWideScan =
    R"({"robots": [{"laser": {"samples": 5000, "resolution_deg": 0.05, "frequency": 60}}]})";

int PortOfStream(LineClient& client, const std::string& component) {
  const std::string reply = client.Ask("1 simulation get_stream_port [\"" + component + "\"]");
  return std::stoi(reply.substr(reply.rfind(' ') + 1));
}

double SecondsOfThisThread() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double QuantileOf(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return values.at(static_cast<std::size_t>(share * last));
}

// The ticks of a run, each with the phase of the test in which it was.
class TickTimes : public RunWatcher {
 public:
  // Even: without readers, odd: with them. Any thread.
  std::atomic<int> phase{-1};

  void Acted() override {
    const double processor = SecondsOfThisThread();
    const auto now = std::chrono::steady_clock::now();
    if (ticks_ == 0) start_ = now;
    const double wall = std::chrono::duration<double>(now - start_).count();
    const int in = phase;
    if (in >= 0 && ticks_ > 0) {
      processor_.at(static_cast<std::size_t>(in)).push_back(processor - last_processor_);
      late_.at(static_cast<std::size_t>(in)).push_back(wall - ticks_ * kTickOfReaders);
    }
    last_processor_ = processor;
    ++ticks_;
  }

  // After the run. Processor time of a tick, s, of which the share of them takes no more.
  double ProcessorTime(bool with_readers, double share) const {
    std::vector<double> all;
    for (std::size_t i = with_readers ? 1 : 0; i < processor_.size(); i += 2) {
      all.insert(all.end(), processor_[i].begin(), processor_[i].end());
    }
    return QuantileOf(all, share);
  }
  // How much later ticks are with readers than right before without, s, at the median.
  double MoreLate() const {
    std::vector<double> more;
    for (std::size_t i = 0; i < late_.size(); i += 2) {
      more.push_back(QuantileOf(late_[i + 1], 0.5) - QuantileOf(late_[i], 0.5));
    }
    return QuantileOf(more, 0.5);
  }

 private:
  std::array<std::vector<double>, kPhasesOfReaders> processor_;  // of the phases
  std::array<std::vector<double>, kPhasesOfReaders> late_;
  std::chrono::steady_clock::time_point start_;
  double last_processor_ = 0.0;
  int ticks_ = 0;
};

// Reads from all streams without end: `bytes` at a time, then it waits for the pause.
class ReadingThread {
 public:
  ReadingThread(std::vector<std::unique_ptr<LineClient>>& streams, std::size_t bytes,
                std::chrono::milliseconds pause)
      : thread_([this, &streams, bytes, pause] {
          while (!stop_) {
            for (const auto& stream : streams) {
              stream->ReadBytes(bytes, std::chrono::milliseconds(20));
            }
            std::this_thread::sleep_for(pause);
          }
        }) {}
  ~ReadingThread() {
    stop_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

// `bytes` that each reader reads at a time, 0: it never reads.
void Measure(TickTimes& times, std::size_t bytes, std::chrono::milliseconds pause) {
  ServedSimulation served(kWideScan, Pace::kRealTime, 0.0, {}, 1, {}, 10.0, {},
                          [&](Runner& runner) { runner.AddWatcher(times); });
  LineClient client(served.port());
  const int port = PortOfStream(client, "s1r.hokuyo");
  for (int round = 0; round < kRoundsOfReaders; ++round) {
    times.phase = 2 * round;
    client.Ask("1 time sleep [0.3]");
    times.phase = 2 * round + 1;
    std::vector<std::unique_ptr<LineClient>> readers;
    for (int i = 0; i < kReadersOfAScan; ++i) readers.push_back(std::make_unique<LineClient>(port));
    std::unique_ptr<ReadingThread> reading;
    if (bytes > 0) reading = std::make_unique<ReadingThread>(readers, bytes, pause);
    client.Ask("1 time sleep [0.6]");  // their buffers are full after 0.2 s
    times.phase = -1;
    reading.reset();
    readers.clear();
  }
  client.Ask("1 simulation quit");
  served.Join();
}

void ExpectNoWorkOfReaders(const TickTimes& times, double share) {
  const double without = times.ProcessorTime(false, share);
  const double with = times.ProcessorTime(true, share);
  std::printf("a tick, %.0f%% of them: %.0f us, with 8 readers %.0f us; %.2f ms later\n",
              100.0 * share, without * 1e6, with * 1e6, times.MoreLate() * 1e3);
  EXPECT_LT(with, without + kMostProcessorTimeMore);
}

TEST(StreamReaders, OnesThatNeverReadNeverDelayATick) {
  TickTimes times;
  Measure(times, 0, {});
  // A third of the ticks with readers are those in which their buffers get full.
  ExpectNoWorkOfReaders(times, 0.9);
  EXPECT_LT(times.MoreLate(), kMostLateness);
}

TEST(StreamReaders, OnesThatReadLittleNeverDelayATick) {
  TickTimes times;
  Measure(times, 20'000, std::chrono::milliseconds(5));
  ExpectNoWorkOfReaders(times, 0.9);
  EXPECT_LT(times.MoreLate(), kMostLateness);
}

// Their reading takes time of the machine, so that ticks may be late where it has no more.
TEST(StreamReaders, OnesThatReadAllMakeNoTickLonger) {
  TickTimes times;
  Measure(times, 300'000, std::chrono::milliseconds(0));
  ExpectNoWorkOfReaders(times, 0.5);
}

// A scene of scanners, in pause; the lines of `component` are those that a service tells.
void ExpectEachLine(const std::string& scene, Pace pace, const std::string& component) {
  ServedSimulation served(scene, pace);
  LineClient client(served.port());
  client.Ask("1 ccmorse pause");
  const int port = PortOfStream(client, component);
  std::vector<std::unique_ptr<LineClient>> slow;
  for (int i = 0; i < kReadersOfAScan; ++i) slow.push_back(std::make_unique<LineClient>(port));
  std::vector<std::unique_ptr<LineClient>> readers;
  for (int i = 0; i < 3; ++i) readers.push_back(std::make_unique<LineClient>(port));
  // One connection is taken at a time, and one at least from one request to the next.
  for (std::size_t i = 0; i < 2 * (slow.size() + readers.size()); ++i) client.Ask("1 ccmorse ping");
  for (int tick = 0; tick < 40; ++tick) {
    client.Ask("1 ccmorse step [1]");
    std::string line;
    for (const auto& reader : readers) {
      const auto got = reader->ReadLine();
      ASSERT_TRUE(got) << "in tick " << tick;
      if (line.empty()) line = *got;
      ASSERT_EQ(*got, line);
    }
    ASSERT_EQ("1 SUCCESS " + line, client.Ask("1 " + component + " get_local_data"));
  }
}

TEST(StreamReaders, WhoReadsGetsEachLineBesideSlowOnesByTheClock) {
  ExpectEachLine(kWideScan, Pace::kRealTime, "s1r.hokuyo");
}

TEST(StreamReaders, WhoReadsGetsEachLineBesideSlowOnesAtFullSpeed) {
  ExpectEachLine(kWideScan, Pace::kMax, "s1r.hokuyo");
}

TEST(StreamReaders, LinesOfShortSensorsAreWhatServicesTell) {
  ExpectEachLine(kWideScan, Pace::kRealTime, "s1r.pose");
}

TEST(StreamReaders, LinesOfScannersInLayersAreWhatServicesTell) {
  ExpectEachLine(R"({"robots": [{"pose": {"x": 1.2, "y": 2.0, "yaw_deg": 30}, "laser": {"samples":
      60, "resolution_deg": 3.0, "layers": 4, "frequency": 60, "range_std": 0.01}}]})",
                 Pace::kRealTime, "s1r.hokuyo");
}

}  // namespace
}  // namespace ccmorse::servers
