#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "base/json.h"
#include "client/core/address.h"
#include "client/core/connection.h"
#include "client/core/device_registry.h"
#include "client/core/rhythm.h"
#include "client/core/subscription.h"
#include "libCCMorse/MorseClient.h"
#include "wire/fast_link.h"
#include "wire/player/frame.h"

namespace CCMorse {

namespace wire = ccmorse::wire;
using Clock = std::chrono::steady_clock;
using core::Batch;
using core::Connection;
using core::Reply;

namespace {

constexpr double kMorseTick = 1.0 / 60.0;  // s; MORSE's default frequency
constexpr double kConnectSilence = 1.9;    // s without any answer while connecting
// The same within the program, where it is known who is there: only a busy machine is that slow.
constexpr double kInProcessSilence = 30.0;
constexpr double kRequestTimeout = 5.0;  // s, Player's default
constexpr double kCloseTimeout = 0.5;    // s for the last commands
constexpr char kReadFunction[] = "MorseClient::Read()";

constexpr int kUnknownInterface = 0xFFFF;

/// The clients in being. A client that only PlayerClients use is kept by them; one that was asked
/// for by GetInstance() is kept here.
struct Directory {
  struct Entry {
    std::weak_ptr<MorseClient> counted;   // what Share() gives out
    std::shared_ptr<MorseClient> pinned;  // a reference that GetInstance() gave out
  };
  std::mutex mutex;
  std::map<std::pair<std::string, int>, Entry> entries;
  std::weak_ptr<MorseClient> last;
  std::vector<std::shared_ptr<MorseClient>> retired;  // references to these are still out
};

Directory& TheDirectory() {
  static Directory directory;
  return directory;
}

// Host and port of whatever address a program gives.
std::pair<std::string, int> ResolveAddress(const std::string& address, int port) {
  constexpr char kFunction[] = "MorseClient::GetInstance()";
  core::Location location = core::ParseAddress(address, port, kFunction);
  if (location.scheme == "player") {
    throw MorseError(address + " is a Player server's address; a PlayerClient speaks to those",
                     kFunction);
  }
  if (location.scheme == "sim") return {location.host, location.port};
  auto [host, number] = core::AddressFor(location.host, location.port);
  if (core::IsInProcess(host)) number = 0;
  return {host, number};
}

// At the program's end: what clients of simulations within it have queued is still done.
void CloseInProcess() {
  std::vector<std::shared_ptr<MorseClient>> clients;
  Directory& directory = TheDirectory();
  {
    const std::lock_guard lock(directory.mutex);
    for (const auto& [address, entry] : directory.entries) {
      if (!core::IsInProcess(address.first)) continue;
      if (const std::shared_ptr<MorseClient> client = entry.counted.lock()) {
        clients.push_back(client);
      }
    }
  }
  for (const auto& client : clients) client->Close();
}

// Closes the client when the last of its sharers goes. Proxies keep the client object, not this.
struct Share {
  explicit Share(std::shared_ptr<MorseClient> c) : client(std::move(c)) {}
  ~Share() { client->Close(); }
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;
  const std::shared_ptr<MorseClient> client;
};

// The value of a successful answer; nothing when it is no JSON.
std::optional<MorseValue> ValueOf(const Reply& reply) {
  if (reply.text.empty()) return MorseValue();
  try {
    return MorseValue::Parse(reply.text);
  } catch (const MorseError&) {
    return std::nullopt;
  }
}

// What the environment says: "json" keeps a program to lines.
bool FastLinkAllowed() {
  const char* const link = std::getenv("CCMORSE_LINK");
  return link == nullptr || std::string_view(link) != "json";
}

// The name of the running program, for the simulator's log; empty where the system does not tell.
std::string ProgramName() {
#ifdef __GLIBC__
  return program_invocation_short_name;
#else
  return "";
#endif
}

// Why a service was refused, without the quotes.
std::string Reason(const std::string& text) {
  try {
    const MorseValue value = MorseValue::Parse(text);
    if (value.IsString()) return value.GetString("");
  } catch (const MorseError&) {
    // No JSON: the raw text has to do.
  }
  return text.empty() ? "no reason given" : text;
}

std::string Hello() {
  std::string hello = R"([{"client": "libCCMorse", "protocol": 1, "program": )";
  ccmorse::AppendJson(hello, std::string_view(ProgramName()));
  return hello + "}]";
}

MorseError ReadError(const std::string& text) {
  const std::string reason = Reason(text);
  const bool ended = reason.find("simulation has ended") != std::string::npos;
  return MorseError(reason, kReadFunction, ended ? MorseError::kSimulationEnded : -1);
}

}  // namespace

// Locking order: read_mutex, then data_mutex or state_mutex, and never a wait under the last two.
struct MorseClient::Impl {
  Impl(const std::string& h, int p) : host(h), port(p), connection(h, p) {}

  // A Read() on its way.
  struct Round {
    std::shared_ptr<Batch> batch;
    std::vector<MorseDevice*> devices;
    // Of AskWithRead(). Their answers come before the read's: in a batch of their own over a fast
    // link, else first in `batch`.
    std::vector<std::function<void(const MorseValue&)>> takers;
    std::shared_ptr<Batch> asked;
  };

  const std::string host;
  const int port;
  Connection connection;

  // Fixed once connected.
  std::vector<std::unique_ptr<MorseRobot>> robots;
  std::vector<std::unique_ptr<MorseDevice>> devices;
  std::vector<MorseRobot*> robot_list;
  bool ccmorse = false;
  std::string server = "MORSE";
  std::string pace = "realtime";
  double frequency = 60.0;
  double read_period = kMorseTick;

  std::mutex data_mutex;  // devices' data, subscriptions, time
  double time = 0.0;
  std::uint64_t rounds = 0;  // reads over a fast link

  std::mutex read_mutex;              // held for a whole Read()
  std::shared_ptr<Round> unfinished;  // under read_mutex: a Read() that was abandoned
  std::vector<std::shared_ptr<MorseSubscription>> deliveries;  // under read_mutex: scratch
  // What AskWithRead() is answered, under read_mutex: scratch.
  std::vector<std::pair<std::function<void(const MorseValue&)>, MorseValue>> answers;
  // Of a fast link, under read_mutex.
  std::shared_ptr<Round> fast_round;
  std::vector<wire::DataForm> forms;  // of the devices, as the server knows them
  std::vector<core::FastLinkWriter::Subscription> changes;  // scratch
  std::vector<double> numbers;                              // scratch

  mutable std::mutex state_mutex;
  std::condition_variable state_changed;
  bool in_read = false;
  std::uint64_t reads = 0;
  bool peeked = true;  // since the last Read(); true before the first one
  Clock::time_point last_read{};
  core::Rhythm rhythm;  // of data, in real time
  double request_timeout = kRequestTimeout;
  int retry_limit = 0;
  double retry_time = 2.0;

  std::mutex prepare_mutex;
  std::vector<std::weak_ptr<std::function<void()>>> prepare;
  std::vector<core::Request> questions;                        // of AskWithRead()
  std::vector<std::function<void(const MorseValue&)>> takers;  // of the same

  std::mutex thread_mutex;  // thread
  std::thread thread;
  std::atomic<bool> stop_thread{false};
  std::atomic<bool> thread_ended{false};
  std::atomic<bool> stop_run{false};
  std::atomic<bool> closed{false};

  // Of BeforeRead(). What is called is copied: it may take as long as it likes, or come and go.
  void Prepare() {
    std::vector<std::shared_ptr<std::function<void()>>> calls;
    {
      const std::lock_guard lock(prepare_mutex);
      std::erase_if(prepare, [](const auto& call) { return call.expired(); });
      for (const auto& call : prepare) calls.push_back(call.lock());
    }
    for (const auto& call : calls) {
      if (call) (*call)();
    }
  }

  // What AskWithRead() has collected.
  std::vector<core::Request> TakeQuestions(Round& round) {
    const std::lock_guard lock(prepare_mutex);
    round.takers = std::exchange(takers, {});
    return std::exchange(questions, {});
  }

  // Of a read that is over: whom to hand which answer.
  void CollectAnswers(Round& round) {
    const std::vector<Reply>* replies = &round.batch->replies;
    if (round.asked) {
      replies = &round.asked->replies;
      // They have come before the read's answer; else they are given up.
      Connection::Patience patience;
      patience.silence = 0.001;
      try {
        if (connection.Wait(round.asked, patience, kReadFunction) != Connection::Outcome::kDone) {
          round.takers.clear();
        }
      } catch (const MorseError&) {
        round.takers.clear();  // the next Read() reports a lost connection
      }
    }
    for (std::size_t i = 0; i < round.takers.size(); ++i) {
      const Reply& reply = (*replies)[i];
      if (!reply.success) continue;
      if (auto value = ValueOf(reply)) answers.emplace_back(round.takers[i], std::move(*value));
    }
    round.takers.clear();
    round.asked.reset();
  }

  // --- The two ways to read; the read_mutex is held.

  using Due = std::vector<std::shared_ptr<MorseSubscription>>;

  // JSON: one query a device.
  std::shared_ptr<Round> SendQueries() {
    auto round = std::make_shared<Round>();
    std::vector<core::Request> requests = TakeQuestions(*round);
    if (ccmorse) requests.push_back({"ccmorse", "read", ""});
    {
      const std::lock_guard lock(data_mutex);
      for (const auto& device : devices) {
        if (device->polled_) round->devices.push_back(device.get());
      }
    }
    for (const MorseDevice* device : round->devices) {
      requests.push_back({device->GetName(), "get_local_data", ""});
    }
    // Plain MORSE with nothing to ask: its clock paces the loop.
    if (!ccmorse && round->devices.empty()) requests.push_back({"time", "now", ""});
    round->batch = connection.Send(requests);
    return round;
  }

  void TakeAnswers(const Round& round, std::optional<MorseError>& error, Due& due) {
    // The texts are parsed before the data are locked.
    const std::vector<Reply>& replies = round.batch->replies;
    const std::size_t read = round.takers.size();
    const std::size_t first = read + (ccmorse ? 1 : 0);
    std::vector<std::optional<MorseValue>> values;
    for (std::size_t i = 0; i < round.devices.size(); ++i) {
      const Reply& reply = replies[first + i];
      values.push_back(reply.success ? ValueOf(reply) : std::nullopt);
    }
    double now = std::numeric_limits<double>::quiet_NaN();
    if (ccmorse) {
      if (replies[read].success) {
        now = ValueOf(replies[read]).value_or(MorseValue()).GetDouble("time", now);
      } else {
        error.emplace(ReadError(replies[read].text));
      }
    } else if (round.devices.empty() && replies[read].success) {
      now = ValueOf(replies[read]).value_or(MorseValue()).GetDouble("", now);
    }

    const std::lock_guard lock(data_mutex);
    for (std::size_t i = 0; i < round.devices.size(); ++i) {
      if (!values[i]) continue;
      round.devices[i]->Accept(*values[i]);
      if (!ccmorse && round.devices[i]->valid_) {
        now = std::fmax(now, round.devices[i]->timestamp_);
      }
    }
    Refresh(now, due);
  }

  // The fast link: what has changed in the subscriptions, and a read.
  std::shared_ptr<Round> SendFastRead() {
    // One round is enough for all reads, one after the other.
    if (!fast_round) {
      fast_round = std::make_shared<Round>();
      fast_round->batch = std::make_shared<Batch>();
      forms.assign(devices.size(), wire::DataForm::kNone);
    }
    changes.clear();
    {
      const std::lock_guard lock(data_mutex);
      for (std::size_t i = 0; i < devices.size() && i < wire::kMostDeclared; ++i) {
        const wire::DataForm form = WantedForm(*devices[i]);
        if (form == forms[i]) continue;
        forms[i] = form;
        changes.push_back({static_cast<std::uint16_t>(i), form, &devices[i]->GetName()});
      }
    }
    const std::vector<core::Request> requests = TakeQuestions(*fast_round);
    if (!requests.empty()) fast_round->asked = connection.Send(requests);
    connection.SendRead(changes, fast_round->batch);
    return fast_round;
  }

  wire::DataForm WantedForm(const MorseDevice& device) const {  // data_mutex held
    if (!device.polled_) return wire::DataForm::kNone;
    if (device.wants_text_ || device.Form() == MorseDevice::DataForm::kText) {
      return wire::DataForm::kText;
    }
    // Nobody knows before the first Read() what a program will look at.
    if (rounds > 0 && !device.in_use_) return wire::DataForm::kNone;
    return static_cast<wire::DataForm>(device.Form());
  }

  void TakeFastData(const Round& round, std::optional<MorseError>& error, Due& due) {
    const Batch& batch = *round.batch;
    if (batch.read_failed) {
      error.emplace(ReadError(batch.data));
      return;
    }
    const std::lock_guard lock(data_mutex);
    ++rounds;
    wire::ByteReader reader(batch.data);
    const double now = reader.Double();
    wire::DataEntry entry;
    while (wire::NextDataEntry(reader, &entry)) {
      if (entry.id >= devices.size()) continue;
      MorseDevice& device = *devices[entry.id];
      device.round_ = rounds;
      if (entry.form == wire::DataForm::kText) {
        try {
          device.Accept(MorseValue::Parse(std::string(entry.bytes)));
        } catch (const MorseError&) {
          // No JSON: not taken.
        }
      } else if (static_cast<wire::DataForm>(device.Form()) == entry.form) {
        numbers.resize(entry.bytes.size() / sizeof(double));
        wire::CopyDoubles(entry.bytes.data(), numbers.size(), numbers.data());
        device.AcceptNumbers(entry.timestamp, numbers.data(), numbers.size());
      }
    }
    Refresh(reader.ok() ? now : std::numeric_limits<double>::quiet_NaN(), due);
  }

  // Time, and which subscriptions have data to deliver, after new data; data_mutex held.
  void Refresh(double now, Due& due) {
    if (std::isfinite(now)) time = now;
    for (const auto& robot : robots) {
      for (const auto& subscription : robot->subscriptions_) {
        if (subscription->device->has_data_) due.push_back(subscription);
      }
    }
  }

  double ConnectSilence() const {
    return core::IsInProcess(host) ? kInProcessSilence : kConnectSilence;
  }

  std::vector<Reply> Ask(const std::vector<core::Request>& requests) {
    const auto batch = connection.Send(requests);
    Connection::Patience patience;
    patience.silence = ConnectSilence();
    if (connection.Wait(batch, patience, "MorseClient::MorseClient()") !=
        Connection::Outcome::kDone) {
      throw MorseError("cannot connect to " + core::AddressText(host, port) +
                           ": something listens there, but does not answer as a simulator does",
                       "MorseClient::MorseClient()");
    }
    return batch->replies;
  }
};

MorseClient::MorseClient(const std::string& host, int port)
    : impl_(std::make_unique<Impl>(host, port)) {}

MorseClient::~MorseClient() { Close(); }

std::shared_ptr<MorseClient> MorseClient::Share(const std::string& asked_host, int asked_port) {
  const auto [host, port] = ResolveAddress(asked_host, asked_port);
  Directory& directory = TheDirectory();
  const std::lock_guard lock(directory.mutex);
  Directory::Entry& entry = directory.entries[{host, port}];
  if (std::shared_ptr<MorseClient> client = entry.counted.lock()) {
    if (client->Connected()) return client;
    if (entry.pinned) directory.retired.push_back(std::move(entry.pinned));
    entry = Directory::Entry();
  }
  const std::shared_ptr<MorseClient> client(new MorseClient(host, port));
  client->Connect();
  const auto share = std::make_shared<CCMorse::Share>(client);
  std::shared_ptr<MorseClient> counted(share, client.get());
  entry.counted = counted;
  directory.last = counted;
  // Behind what the simulator's library registered when it was opened, so that this comes first.
  if (core::IsInProcess(host)) std::atexit(CloseInProcess);
  return counted;
}

MorseClient& MorseClient::GetInstance(const std::string& asked_host, int asked_port) {
  const auto [host, port] = ResolveAddress(asked_host, asked_port);
  std::shared_ptr<MorseClient> client = Share(host, port);
  Directory& directory = TheDirectory();
  const std::lock_guard lock(directory.mutex);
  MorseClient& result = *client;
  Directory::Entry& entry = directory.entries[{host, port}];
  if (entry.pinned != client) {
    if (entry.pinned) directory.retired.push_back(std::move(entry.pinned));
    entry.pinned = std::move(client);
  }
  return result;
}

MorseClient& MorseClient::GetInstance() {
  Directory& directory = TheDirectory();
  const std::lock_guard lock(directory.mutex);
  const std::shared_ptr<MorseClient> client = directory.last.lock();
  if (!client) {
    throw MorseError("there is no client yet: call GetInstance(host, port) first",
                     "MorseClient::GetInstance()");
  }
  return *client;
}

void MorseClient::Connect() {
  constexpr char kFunction[] = "MorseClient::MorseClient()";
  Impl& impl = *impl_;
  const std::vector<Reply> replies = impl.Ask({{"simulation", "list_robots", ""},
                                               {"simulation", "details", ""},
                                               {"ccmorse", "hello", Hello()}});
  const auto answer = [&](std::size_t i, const char* what) {
    const std::optional<MorseValue> value = ValueOf(replies[i]);
    if (!replies[i].success || !value) {
      throw MorseError("cannot connect to " + core::AddressText(impl.host, impl.port) +
                           ": simulation " + what + " was answered with " +
                           (replies[i].success ? "no JSON" : Reason(replies[i].text)),
                       kFunction);
    }
    return *value;
  };
  const std::vector<std::string> names = answer(0, "list_robots").GetStrings("");
  const MorseValue details = answer(1, "details");
  bool fast = false;
  if (replies[2].success) {
    const MorseValue hello = ValueOf(replies[2]).value_or(MorseValue());
    impl.ccmorse = true;
    impl.server = hello.GetString("server", "ccmorse");
    impl.pace = hello.GetString("pace", "realtime");
    impl.frequency = hello.GetDouble("frequency", 60.0);
    impl.read_period = hello.GetDouble("read_period", kMorseTick);
    fast = hello.GetInt("fast_link") == wire::kFastLinkVersion && FastLinkAllowed();
  }
  impl.connection.SetPing(impl.ccmorse ? "ccmorse ping" : "time now");

  for (const std::string& name : names) {
    MorseValue described;
    const MorseValue robots = details.Member("robots");
    for (std::size_t i = 0; i < robots.GetSize(); ++i) {
      if (robots.At(i).GetString("name") == name) described = robots.At(i);
    }
    impl.robots.push_back(std::make_unique<MorseRobot>(*this, name, described.GetString("type")));
    MorseRobot& robot = *impl.robots.back();
    impl.robot_list.push_back(&robot);
    const MorseValue components = described.Member("components");
    for (const std::string& component : components.GetKeys()) {
      MorseDeviceInfo info;
      info.client = this;
      info.robot = &robot;
      info.name = component;
      info.type = components.Member(component).GetString("type");
      info.services = components.Member(component).GetStrings("services");
      impl.devices.push_back(core::MakeDevice(info));
      robot.devices_.push_back(impl.devices.back().get());
    }
  }

  std::vector<core::Request> requests;
  std::vector<MorseDevice*> askers;
  for (const auto& device : impl.devices) {
    for (const std::string& service : device->SetupServices()) {
      if (!device->HasService(service)) continue;
      requests.push_back({device->GetName(), service, ""});
      askers.push_back(device.get());
    }
  }
  if (!requests.empty()) {
    const std::vector<Reply> setup = impl.Ask(requests);
    for (std::size_t i = 0; i < setup.size(); ++i) {
      const std::optional<MorseValue> value = ValueOf(setup[i]);
      // A device that gets no settings stays invalid; the others work.
      if (setup[i].success && value) askers[i]->OnSetup(requests[i].service, *value);
    }
  }
  if (fast) {
    Connection::Patience patience;
    patience.silence = impl.ConnectSilence();
    impl.connection.StartFastLink(patience, kFunction);
  }
}

void MorseClient::Close() noexcept {
  Impl& impl = *impl_;
  if (impl.closed.exchange(true)) return;
  impl.stop_run = true;
  StopThread();
  impl.connection.Close(kCloseTimeout);
}

bool MorseClient::Connected() const { return impl_->connection.Alive(); }
std::string MorseClient::GetHostname() const { return impl_->host; }
std::uint32_t MorseClient::GetPort() const { return static_cast<std::uint32_t>(impl_->port); }
std::mutex& MorseClient::DataMutex() const { return impl_->data_mutex; }

void MorseClient::Read() { ReadOnce(false); }

std::shared_ptr<void> MorseClient::BeforeRead(std::function<void()> prepare) {
  auto handle = std::make_shared<std::function<void()>>(std::move(prepare));
  const std::lock_guard lock(impl_->prepare_mutex);
  impl_->prepare.push_back(handle);
  return handle;
}

void MorseClient::ReadOnce(bool may_abandon) {
  Impl& impl = *impl_;
  impl.Prepare();
  std::unique_lock read_lock(impl.read_mutex);
  {
    const std::lock_guard lock(impl.state_mutex);
    impl.in_read = true;
  }
  impl.connection.SetReading(true);
  const auto leave = [&](bool finished) {
    impl.connection.SetReading(false);
    const std::lock_guard lock(impl.state_mutex);
    impl.in_read = false;
    if (finished) {
      ++impl.reads;
      impl.peeked = false;
      impl.last_read = Clock::now();
    }
    impl.state_changed.notify_all();
  };

  const bool fast = impl.connection.IsFast();
  std::shared_ptr<Impl::Round> round = std::exchange(impl.unfinished, nullptr);
  try {
    if (!round) round = fast ? impl.SendFastRead() : impl.SendQueries();
    Connection::Patience patience;
    if (may_abandon) patience.abandon = &impl.stop_thread;
    // In real time data come at regular intervals.
    if (impl.pace == "realtime") patience.expected = impl.rhythm.expected();
    if (impl.connection.Wait(round->batch, patience, kReadFunction) ==
        Connection::Outcome::kAbandoned) {
      impl.unfinished = round;
      leave(false);
      return;
    }
    impl.rhythm.Came(Clock::now());
  } catch (...) {
    leave(false);
    throw;
  }

  std::optional<MorseError> error;
  Impl::Due& due = impl.deliveries;
  due.clear();
  if (fast) {
    impl.TakeFastData(*round, error, due);
  } else {
    impl.TakeAnswers(*round, error, due);
  }
  std::erase_if(due, [](const auto& subscription) { return !subscription->deliver(); });
  impl.CollectAnswers(*round);
  const auto answers = std::exchange(impl.answers, {});
  const Impl::Due signalled = due;
  due.clear();
  leave(true);
  const std::optional<core::Refusal> refusal = impl.connection.TakeRefusal();
  read_lock.unlock();
  for (const auto& subscription : signalled) subscription->signal();
  for (const auto& [take, value] : answers) take(value);

  if (!error && refusal) {
    error.emplace("the simulator refused " + refusal->component + " " + refusal->service + ": " +
                      Reason(refusal->reason),
                  kReadFunction, MorseError::kRefused);
  }
  if (error) throw *error;
}

bool MorseClient::Peek(int timeout_ms) {
  constexpr char kFunction[] = "MorseClient::Peek()";
  Impl& impl = *impl_;
  if (!Connected()) {
    throw MorseError("there is no connection to " + core::AddressText(impl.host, impl.port),
                     kFunction);
  }
  const auto timeout = std::chrono::milliseconds(std::max(timeout_ms, 0));
  {
    std::unique_lock lock(impl.state_mutex);
    if (impl.in_read) {
      // Another thread reads: what it brings is what can be waited for.
      const std::uint64_t before = impl.reads;
      impl.state_changed.wait_until(lock, Clock::now() + timeout,
                                    [&] { return impl.reads != before || !impl.in_read; });
      return impl.reads != before;
    }
    // Time stands still between two reads, or runs so fast that there is always more to read.
    if (impl.ccmorse && impl.pace != "realtime") {
      const bool first = !std::exchange(impl.peeked, true);
      return timeout_ms > 0 || !first;
    }
    if (!impl.ccmorse) {
      const auto tick =
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kMorseTick));
      const auto due = impl.reads == 0 ? Clock::now() : impl.last_read + tick;
      const auto deadline = Clock::now() + timeout;
      lock.unlock();
      if (due > deadline) {
        std::this_thread::sleep_until(deadline);
        return false;
      }
      std::this_thread::sleep_until(due);
      return true;
    }
  }
  const double seconds = std::max(timeout_ms, 0) / 1000.0;
  return Request("ccmorse", "peek", MorseArgs(seconds), seconds + GetRequestTimeout()).IsTrue();
}

void MorseClient::ReadIfWaiting() {
  if (Peek(0)) Read();
}

void MorseClient::Run(int timeout_ms) {
  impl_->stop_run = false;
  while (!impl_->stop_run) {
    Read();
    std::this_thread::sleep_for(std::chrono::milliseconds(std::max(timeout_ms, 0)));
  }
}

void MorseClient::Stop() {
  impl_->stop_run = true;
  impl_->stop_thread = true;
}

void MorseClient::StartThread() {
  Impl& impl = *impl_;
  const std::lock_guard lock(impl.thread_mutex);
  if (impl.thread.joinable()) {
    if (!impl.stop_thread && !impl.thread_ended) return;
    impl.connection.Wake();
    impl.thread.join();
  }
  impl.stop_thread = false;
  impl.thread_ended = false;
  impl.thread = std::thread([this] {
    while (!impl_->stop_thread) {
      try {
        ReadOnce(true);
      } catch (const MorseError& error) {
        if (error.GetErrorCode() != MorseError::kRefused) break;
      }
    }
    impl_->thread_ended = true;
  });
}

void MorseClient::StopThread() {
  Impl& impl = *impl_;
  const std::lock_guard lock(impl.thread_mutex);
  impl.stop_thread = true;
  impl.connection.Wake();
  if (!impl.thread.joinable()) return;
  if (impl.thread.get_id() == std::this_thread::get_id()) return;  // from a read signal
  impl.thread.join();
}

void MorseClient::SetRequestTimeout(double seconds) {
  if (!(seconds > 0.0)) {
    throw MorseError("a timeout is above 0 s", "MorseClient::SetRequestTimeout()");
  }
  const std::lock_guard lock(impl_->state_mutex);
  impl_->request_timeout = seconds;
}

double MorseClient::GetRequestTimeout() const {
  const std::lock_guard lock(impl_->state_mutex);
  return impl_->request_timeout;
}

void MorseClient::SetRetryLimit(int limit) {
  const std::lock_guard lock(impl_->state_mutex);
  impl_->retry_limit = limit;
}

int MorseClient::GetRetryLimit() const {
  const std::lock_guard lock(impl_->state_mutex);
  return impl_->retry_limit;
}

void MorseClient::SetRetryTime(double seconds) {
  const std::lock_guard lock(impl_->state_mutex);
  impl_->retry_time = seconds;
}

double MorseClient::GetRetryTime() const {
  const std::lock_guard lock(impl_->state_mutex);
  return impl_->retry_time;
}

void MorseClient::SetDataMode(int /*mode*/) {}
void MorseClient::SetReplaceRule(bool /*replace*/, int /*type*/, int /*subtype*/, int /*interf*/) {}
void MorseClient::RequestDeviceList() {}

std::list<playerc_device_info_t> MorseClient::GetDeviceList() const {
  std::list<playerc_device_info_t> list;
  for (const MorseRobot* robot : impl_->robot_list) {
    for (const MorseDevice* device : robot->GetDevices()) {
      const auto* source = dynamic_cast<const MorsePropertySource*>(device);
      if (!source) continue;
      const MorseValue proxies = source->GetAll().Member("proxies");
      for (const std::string& interface : proxies.GetKeys()) {
        const MorseValue indexes = proxies.Member(interface);
        for (const std::string& index : indexes.GetKeys()) {
          playerc_device_info_t info{};
          info.addr.robot = GetPort();
          info.addr.interf = static_cast<std::uint16_t>(LookupCode(interface));
          info.addr.index = static_cast<std::uint16_t>(std::strtoul(index.c_str(), nullptr, 10));
          const std::string name = robot->GetName() + "." + indexes.GetString(index);
          std::strncpy(info.drivername, name.c_str(), sizeof(info.drivername) - 1);
          list.push_back(info);
        }
      }
    }
  }
  return list;
}

int MorseClient::LookupCode(const std::string& name) const {
  return wire::player::InterfaceCode(name).value_or(kUnknownInterface);
}

std::string MorseClient::LookupName(int code) const {
  const std::string_view name = wire::player::InterfaceName(static_cast<std::uint16_t>(code));
  return code < 0 || code > 0xFFFF || name.empty() ? "unknown" : std::string(name);
}

std::uint32_t MorseClient::GetOverflowCount() { return 0; }

const std::vector<MorseRobot*>& MorseClient::GetRobots() const { return impl_->robot_list; }

MorseRobot& MorseClient::GetRobot(const std::string& name) const {
  std::string known;
  for (MorseRobot* robot : impl_->robot_list) {
    if (robot->GetName() == name) return *robot;
    known += (known.empty() ? "" : ", ") + robot->GetName();
  }
  throw MorseError(
      "there is no robot \"" + name + "\"; there is " + (known.empty() ? "none" : known),
      "MorseClient::GetRobot()");
}

std::vector<MorseDevice*> MorseClient::GetDevices() const {
  std::vector<MorseDevice*> devices;
  for (const auto& device : impl_->devices) devices.push_back(device.get());
  return devices;
}

bool MorseClient::IsCCMorse() const { return impl_->ccmorse; }
std::string MorseClient::GetServerName() const { return impl_->server; }
std::string MorseClient::GetPace() const { return impl_->pace; }
std::string MorseClient::GetLink() const { return impl_->connection.IsFast() ? "fast" : "json"; }
double MorseClient::GetFrequency() const { return impl_->frequency; }
double MorseClient::GetReadPeriod() const { return impl_->read_period; }

double MorseClient::GetTime() const {
  const std::lock_guard lock(impl_->data_mutex);
  return impl_->time;
}

void MorseClient::Command(const std::string& component, const std::string& service,
                          const MorseArgs& args) {
  impl_->connection.Queue({component, service, args.ToString()});
}

MorseValue MorseClient::Request(const std::string& component, const std::string& service,
                                const MorseArgs& args, double timeout) {
  constexpr char kFunction[] = "MorseClient::Request()";
  Impl& impl = *impl_;
  const std::string what = component + " " + service;
  Connection::Patience patience;
  patience.timeout = timeout > 0.0 ? timeout : GetRequestTimeout();
  const auto batch = impl.connection.Send({{component, service, args.ToString()}});
  if (impl.connection.Wait(batch, patience, kFunction) == Connection::Outcome::kTimeout) {
    throw MorseError("no answer to " + what + " in time", kFunction);
  }
  const Reply& reply = batch->replies[0];
  if (reply.preempted) {
    throw MorseError("another request took the place of " + what, kFunction,
                     MorseError::kPreempted);
  }
  if (!reply.success) {
    throw MorseError("the simulator refused " + what + ": " + Reason(reply.text), kFunction,
                     MorseError::kRefused);
  }
  const std::optional<MorseValue> value = ValueOf(reply);
  if (!value) throw MorseError("the answer to " + what + " is no JSON", kFunction);
  return *value;
}

void MorseClient::Fetch(const std::string& device, bool text) {
  Impl& impl = *impl_;
  if (!impl.connection.IsFast()) return;
  const auto found = std::find_if(impl.devices.begin(), impl.devices.end(),
                                  [&](const auto& entry) { return entry->GetName() == device; });
  if (found == impl.devices.end()) return;
  {
    // Before the first Read(), and during one, the program has nothing newer to expect.
    const std::lock_guard lock(impl.state_mutex);
    if (!text && (impl.in_read || impl.reads == 0)) return;
  }
  {
    const std::lock_guard lock(impl.data_mutex);
    const bool current = !text && (*found)->round_ == impl.rounds;
    if (!(*found)->polled_ || current) return;
  }
  try {
    const MorseValue data = Request(device, "get_local_data");
    const std::lock_guard lock(impl.data_mutex);
    (*found)->Accept(data);
  } catch (const MorseError&) {
    // What there was stays; the next Read() reports a lost connection.
  }
}

void MorseClient::AskWithRead(const std::string& component, const std::string& service,
                              std::function<void(const MorseValue&)> take) {
  const std::lock_guard lock(impl_->prepare_mutex);
  impl_->questions.push_back({component, service, ""});
  impl_->takers.push_back(std::move(take));
}

bool MorseClient::QueueNumbers(const std::string& component, const std::string& service,
                               const double* numbers, std::size_t count) {
  return impl_->connection.QueueNumbers(component, service, numbers, count);
}

bool MorseClient::QueueImage(const std::string& component, const std::string& service, int width,
                             int height, const std::vector<Color_t>& image) {
  return impl_->connection.QueueImage(component, service, width, height, image);
}

bool MorseClient::QueuePixels(const std::string& component, const std::string& service,
                              const PixelUpdate_t* pixels, std::size_t count) {
  return impl_->connection.QueuePixels(component, service, pixels, count);
}

void MorseClient::Flush() { impl_->connection.Flush(kRequestTimeout); }

}  // namespace CCMorse
