#include "servers/record/replay.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/json.h"
#include "servers/record/record_format.h"

namespace ccmorse::servers {
namespace {

std::unique_ptr<std::ifstream> OpenRecord(const std::string& file) {
  errno = 0;
  auto stream = std::make_unique<std::ifstream>(file, std::ios::binary);
  if (!*stream) throw RecordError("cannot read " + file + ": " + std::strerror(errno));
  return stream;
}

// Members of a message; each throws RecordError when it is not what it should be.
const Json& Member(const Json& message, const char* key) {
  const Json* const value = message.Find(key);
  if (value == nullptr) throw RecordError(std::string("a message lacks '") + key + "'");
  return *value;
}

std::uint64_t Count(const Json& message, const char* key) {
  const Json& value = Member(message, key);
  if (!value.IsInt() || value.AsInt() < 0) {
    throw RecordError(std::string("'") + key + "' of a message is no count");
  }
  return static_cast<std::uint64_t>(value.AsInt());
}

const std::string& Text(const Json& message, const char* key) {
  const Json& value = Member(message, key);
  if (!value.IsString()) throw RecordError(std::string("'") + key + "' of a message is no text");
  return value.AsString();
}

std::uint64_t Hash(const Json& message, const char* key) {
  std::uint64_t hash = 0;
  if (!ParseHash(Text(message, key), &hash)) {
    throw RecordError(std::string("'") + key + "' of a message is no hash");
  }
  return hash;
}

void ReadStart(const Json& start, RecordInfo* info) {
  if (Count(start, "format") != static_cast<std::uint64_t>(kRecordFormat)) {
    throw RecordError("it is written in format " + std::to_string(Count(start, "format")) +
                      " by ccmorse " + Text(start, "ccmorse") + "; this one reads format " +
                      std::to_string(kRecordFormat));
  }
  info->version = Text(start, "ccmorse");
  info->hash_every = Count(start, "hash_every");
  if (info->hash_every == 0) throw RecordError("'hash_every' is 0");
  const Json* const contest = start.Find("contest");
  info->contest = contest != nullptr && contest->IsBool() && contest->AsBool();
  // The scenario takes its name from its file's.
  info->scenario =
      scene::ParseScenario(Member(start, "scenario").Dump(), Text(start, "name") + ".json");
}

void ReadEnd(const Json& end, RecordInfo* info) {
  info->ticks = Count(end, "tick");
  const Json& sensed = Member(end, "sensed");
  if (!sensed.IsBool()) throw RecordError("'sensed' of a message is not true or false");
  info->sensed = sensed.AsBool();
  info->hash = Hash(end, "hash");
}

RecordInfo ReadInfo(std::istream& stream) {
  wire::McapReader reader(stream);
  RecordInfo info;
  wire::McapMessage message;
  bool ended = false;
  for (std::uint64_t count = 0; reader.Next(&message); ++count) {
    const std::string& topic = message.channel->topic;
    if ((count == 0) != (topic == kStartTopic)) throw RecordError("it is no record of ccmorse");
    if (count == 0) {
      ReadStart(Json::Parse(message.data), &info);
      continue;
    }
    if (ended) throw RecordError("something follows its end");
    // All of a tick's messages come after those of the ticks before.
    const std::uint64_t tick = TickOf(message.log_time, info.scenario.time.frequency);
    if (tick < info.ticks) throw RecordError("its messages are not in the order of their times");
    info.ticks = tick;
    if (topic != kEndTopic) continue;
    ended = true;
    ReadEnd(Json::Parse(message.data), &info);
    if (info.ticks != tick) throw RecordError("its end is not where it says");
  }
  if (info.version.empty()) {
    throw RecordError("it breaks off before its first chunk; there is nothing to replay");
  }
  if (reader.complete() && !ended) throw RecordError("the message about its end is missing");
  info.complete = ended;
  return info;
}

}  // namespace

RecordInfo ReadRecordInfo(const std::string& file) {
  const auto stream = OpenRecord(file);
  try {
    return ReadInfo(*stream);
  } catch (const RecordError& error) {
    throw RecordError("the record " + file + " is of no use: " + error.what());
  } catch (const wire::McapError& error) {
    throw RecordError("the record " + file + " is of no use: " + error.what());
  } catch (const JsonError& error) {
    throw RecordError("the record " + file +
                      " is of no use: a message is no JSON: " + error.what());
  } catch (const Error& error) {
    throw RecordError("the record " + file +
                      " starts from a scenario that this ccmorse cannot simulate: " + error.what());
  }
}

Replay::Replay(const std::string& file, RunControl control)
    : file_(file), control_(std::move(control)), info_(ReadRecordInfo(file)) {
  Start();
}

double Replay::duration() const {
  return static_cast<double>(info_.ticks) / info_.scenario.time.frequency;
}

void Replay::Fail(const std::string& what) const {
  throw RecordError("the record " + file_ + " is of no use: " + what);
}

void Replay::Start() {
  directory_.reset();  // refers to the simulation
  hasher_.reset();
  simulation_ = std::make_unique<sim::Simulation>(info_.scenario);
  RunControl control = control_;
  control.stream_port = [](const sim::Component&) { return 0; };
  control.quit = [] {};
  control.time_mode = [] { return std::string(); };
  control.time_statistics = [] { return Json(); };
  control.set_time_scale = [](double) { return false; };
  directory_ = std::make_unique<ServiceDirectory>(*simulation_, std::move(control));
  directory_->set_contest(info_.contest);
  hasher_ = std::make_unique<ComponentHasher>(*simulation_);
  reader_.reset();  // refers to the stream
  stream_ = OpenRecord(file_);
  try {
    reader_ = std::make_unique<wire::McapReader>(*stream_);
  } catch (const wire::McapError& error) {
    Fail(error.what());
  }
  finished_ = false;
  compared_tick_ = 0;
  difference_.reset();
  message_tick_ = 0;
  ReadMessage();
}

void Replay::ReadMessage() {
  try {
    wire::McapMessage message;
    while (reader_->Next(&message)) {
      const bool is_input = message.channel->topic == kInputTopic;
      if (!is_input && message.channel->topic != kHashTopic) continue;
      message_ = Json::Parse(message.data);
      message_is_input_ = is_input;
      const std::uint64_t tick = Count(message_, "tick");
      if (tick != TickOf(message.log_time, info_.scenario.time.frequency)) {
        throw RecordError("the tick of a message is not that of its time");
      }
      message_tick_ = tick;
      return;
    }
    message_ = Json();
  } catch (const wire::McapError& error) {
    Fail(error.what());
  } catch (const JsonError& error) {
    Fail(std::string("a message is no JSON: ") + error.what());
  } catch (const RecordError& error) {
    Fail(error.what());
  }
}

void Replay::ApplyInputs() {
  while (!message_.IsNull() && message_is_input_ && message_tick_ == simulation_->tick()) {
    try {
      const std::string& kind = Text(message_, "kind");
      Input input;
      input.component = Text(message_, "component");
      if (kind == "service" || kind == "bytes") {
        input.kind = kind == "bytes" ? Input::Kind::kBytes : Input::Kind::kService;
        input.service = Text(message_, "service");
        input.arguments = Text(message_, "arguments");
      } else if (kind == "stream") {
        input.kind = Input::Kind::kStream;
        input.arguments = Text(message_, "arguments");
      } else if (kind == "own") {
        input.kind = Input::Kind::kOwn;
        input.arguments = Text(message_, "arguments");
      } else if (kind == "interrupt") {
        input.kind = Input::Kind::kInterrupt;
      } else {
        throw RecordError("an input is of the kind '" + kind + "', which is not known here");
      }
      directory_->Apply(input);
    } catch (const JsonError& error) {
      Fail(std::string("an input's arguments are no JSON: ") + error.what());
    } catch (const Error& error) {
      Fail(error.what());
    }
    ReadMessage();
  }
}

bool Replay::Step() {
  if (simulation_->tick() >= info_.ticks) {
    Finish();
    return false;
  }
  simulation_->Sense();
  ApplyInputs();
  simulation_->Act();
  directory_->TimeAdvanced();
  Compare();
  return true;
}

void Replay::Compare() {
  const std::uint64_t tick = simulation_->tick();
  while (!message_.IsNull() && !message_is_input_ && message_tick_ == tick) {
    const std::uint64_t first_tick = std::exchange(compared_tick_, tick);
    if (!difference_) {
      difference_ = CompareHashes();
      if (difference_) {
        difference_->first_tick = first_tick;
        difference_->last_tick = tick - 1;
      }
    }
    ReadMessage();
  }
  if (!message_.IsNull() && message_tick_ < tick) {
    Fail("its messages are not in the order of their ticks");
  }
}

std::optional<Difference> Replay::CompareHashes() {
  constexpr const char* kNothing = "nothing";
  const auto text_of = [](const Json* hash) {
    return hash != nullptr && hash->IsString() ? hash->AsString() : std::string(kNothing);
  };
  const Json* const components = message_.Find("components");
  if (components == nullptr || !components->IsObject()) Fail("a message lacks 'components'");
  std::vector<Difference> found;
  const auto compare = [&](const std::string& name, std::string recorded, std::string simulated) {
    if (recorded == simulated) return;
    found.push_back({0, 0, name, "", std::move(recorded), std::move(simulated), 0});
  };
  const std::vector<ComponentHash>& hashes = hasher_->Take();
  for (const ComponentHash& hash : hashes) {
    compare(hash.name, text_of(components->Find(hash.name)), HashText(hash.value));
  }
  for (const auto& [name, hash] : components->AsObject()) {
    const bool known = std::any_of(hashes.begin(), hashes.end(),
                                   [&name = name](const auto& each) { return each.name == name; });
    if (!known) compare(name, text_of(&hash), kNothing);
  }
  const Json* const whole = message_.Find("hash");
  if (whole != nullptr) compare("", text_of(whole), HashText(simulation_->Hash()));
  if (found.empty()) return std::nullopt;
  Difference& first = found.front();
  const sim::Robot* const robot = simulation_->FindRobot(first.component);
  if (robot != nullptr && robot->driver() != nullptr) first.driver = robot->driver()->full_name();
  first.others = static_cast<std::size_t>(
      std::count_if(found.begin() + 1, found.end(),
                    [](const Difference& each) { return !each.component.empty(); }));
  return first;
}

void Replay::Finish() {
  if (std::exchange(finished_, true)) return;
  if (info_.sensed) simulation_->Sense();
  ApplyInputs();
  if (!message_.IsNull() && info_.complete) Fail("it has messages behind its last tick");
  const std::uint64_t hash = simulation_->Hash();
  if (!info_.complete || difference_ || hash == info_.hash) return;
  difference_ =
      Difference{compared_tick_, info_.ticks, "", "", HashText(info_.hash), HashText(hash), 0};
}

void Replay::Seek(double seconds) {
  const double ticks = std::round(seconds * info_.scenario.time.frequency);
  const std::uint64_t tick =
      ticks > 0.0 ? static_cast<std::uint64_t>(std::fmin(ticks, static_cast<double>(info_.ticks)))
                  : 0;
  if (tick < simulation_->tick() || finished_) Start();
  while (simulation_->tick() < tick) Step();
}

}  // namespace ccmorse::servers
