#include "libplayerc++/io.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <deque>
#include <sstream>

#include "client/player/proxy_state.h"

namespace PlayerCc {

namespace {

using AioState = SimpleState<wire::AioData, PLAYER_AIO_DATA_STATE>;
using DioState = SimpleState<wire::DioData, PLAYER_DIO_DATA_VALUES>;
using HealthState = SimpleState<wire::HealthData, PLAYER_HEALTH_DATA_STATE>;
using JoystickState = SimpleState<wire::JoystickData, PLAYER_JOYSTICK_DATA_STATE>;
using OpaqueState = SimpleState<wire::OpaqueData, PLAYER_OPAQUE_DATA_STATE>;
using PowerState = SimpleState<wire::PowerData, PLAYER_POWER_DATA_STATE>;
using RfidState = SimpleState<wire::RfidData, PLAYER_RFID_DATA_TAGS>;
using WsnState = SimpleState<wire::WsnData, PLAYER_WSN_DATA_STATE>;

class AudioState : public ProxyState {
 public:
  wire::AudioWav wav;
  wire::AudioSeq seq;
  wire::AudioMixerChannelList channels;
  wire::AudioMixerChannelListDetail details;
  wire::AudioState state;

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    switch (subtype) {
      case PLAYER_AUDIO_DATA_WAV_REC:
        return Keep(body, wav);
      case PLAYER_AUDIO_DATA_SEQ:
        return Keep(body, seq);
      case PLAYER_AUDIO_DATA_MIXER_CHANNEL:
        return Keep(body, channels);
      case PLAYER_AUDIO_DATA_STATE:
        return Keep(body, state);
      default:
        return false;
    }
  }
};

// An entry in Player's form, whose pointers lead into it.
class Entry {
 public:
  explicit Entry(wire::BlackboardEntry entry) : entry_(std::move(entry)) {
    c.type = entry_.type;
    c.subtype = entry_.subtype;
    c.key_count = static_cast<std::uint32_t>(entry_.key.size() + 1);
    c.key = entry_.key.data();
    c.group_count = static_cast<std::uint32_t>(entry_.group.size() + 1);
    c.group = entry_.group.data();
    c.data_count = static_cast<std::uint32_t>(entry_.data.size());
    c.data = entry_.data.data();
    c.timestamp_sec = entry_.timestamp_sec;
    c.timestamp_usec = entry_.timestamp_usec;
  }
  Entry(const Entry&) = delete;
  Entry& operator=(const Entry&) = delete;
  player_blackboard_entry_t c{};

 private:
  wire::BlackboardEntry entry_;
};

class BlackBoardState : public ProxyState {
 public:
  std::deque<Entry> given;  // to the program, which reads them as long as the proxy lives
  std::vector<wire::BlackboardEntry> updates;  // not yet handed to the handler
  void (*handler)(playerc_blackboard_t*, player_blackboard_entry_t) = nullptr;
  playerc_blackboard_t board{};

  void Signal() override {
    std::vector<wire::BlackboardEntry> taken;
    decltype(handler) called = nullptr;
    {
      const std::lock_guard lock(mutex);
      taken.swap(updates);
      called = handler;
    }
    for (wire::BlackboardEntry& update : taken) {
      if (called == nullptr) break;
      const Entry entry(std::move(update));
      called(&board, entry.c);
    }
    ProxyState::Signal();
  }

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    wire::BlackboardEntry entry;
    if (subtype != PLAYER_BLACKBOARD_DATA_UPDATE || !body.To(entry)) return false;
    updates.push_back(std::move(entry));
    return true;
  }
  bool Pending() const override { return !updates.empty(); }
};

class CoopObjectState : public ProxyState {
 public:
  int kind = PLAYER_COOPOBJECT_MSG_NONE;
  wire::CoopobjectHeader header;
  std::uint32_t proxy_id = 0;
  wire::CoopobjectDataSensor sensors;
  wire::CoopobjectDataSensor alarms;
  wire::CoopobjectDataUserdefined user;
  wire::CoopobjectRssi rssi;
  wire::CoopobjectPosition position;
  wire::CoopobjectReq request;
  wire::CoopobjectCmd command;
  std::vector<std::uint8_t> parameters;  // of the last request or command

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    switch (subtype) {
      case PLAYER_COOPOBJECT_DATA_HEALTH: {
        wire::CoopobjectHeader health;
        if (!body.To(health)) return false;
        header = health;
        kind = PLAYER_COOPOBJECT_MSG_HEALTH;
        return true;
      }
      case PLAYER_COOPOBJECT_DATA_RSSI:
        return TakeOne(body, rssi, PLAYER_COOPOBJECT_MSG_RSSI);
      case PLAYER_COOPOBJECT_DATA_SENSOR:
        return TakeOne(body, sensors, PLAYER_COOPOBJECT_MSG_SENSOR);
      case PLAYER_COOPOBJECT_DATA_ALARM:
        return TakeOne(body, alarms, PLAYER_COOPOBJECT_MSG_ALARM);
      case PLAYER_COOPOBJECT_DATA_USERDEFINED:
        return TakeOne(body, user, PLAYER_COOPOBJECT_DATA_USERDEFINED);
      case PLAYER_COOPOBJECT_DATA_REQUEST:
        if (!TakeOne(body, request, PLAYER_COOPOBJECT_MSG_REQUEST)) return false;
        parameters = request.parameters;
        return true;
      case PLAYER_COOPOBJECT_DATA_COMMAND:
        if (!TakeOne(body, command, PLAYER_COOPOBJECT_MSG_COMMAND)) return false;
        parameters = command.parameters;
        return true;
      case PLAYER_COOPOBJECT_DATA_POSITION:
        return TakeOne(body, position, PLAYER_COOPOBJECT_MSG_POSITION);
      default:
        return false;
    }
  }

 private:
  template <typename Message>
  bool TakeOne(const wire::Body& body, Message& message, int its_kind) {
    if (!Keep(body, message)) return false;
    header = message.header;
    kind = its_kind;
    return true;
  }
};

class LogState : public NoState {
 public:
  wire::LogGetState log;
};

class WordsState : public ProxyState {
 public:
  std::vector<std::string> words;

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    wire::SpeechRecognitionData data;
    if (subtype != PLAYER_SPEECH_RECOGNITION_DATA_STRING || !body.To(data)) return false;
    std::istringstream text(data.text);
    words.clear();
    for (std::string word; text >> word;) words.push_back(word);
    return true;
  }
};

void CopyText(const std::vector<std::uint8_t>& from, std::array<char, 32>& to) {
  to.fill('\0');
  std::copy_n(from.begin(), std::min(from.size(), to.size() - 1), to.begin());
}

class WifiState : public ProxyState {
 public:
  std::vector<playerc_wifi_link_t> links;
  std::array<char, 32> ip{};  // our own, which no message tells

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    wire::WifiData data;
    if (subtype != PLAYER_WIFI_DATA_STATE || !body.To(data)) return false;
    links.clear();
    for (const wire::WifiLink& each : data.links) {
      playerc_wifi_link_t entry{};
      std::array<char, 32> text{};
      CopyText(each.mac, text);
      std::memcpy(entry.mac, text.data(), text.size());
      CopyText(each.ip, text);
      std::memcpy(entry.ip, text.data(), text.size());
      CopyText(each.essid, text);
      std::memcpy(entry.essid, text.data(), text.size());
      entry.mode = static_cast<int>(each.mode);
      entry.encrypt = static_cast<int>(each.encrypt);
      entry.freq = each.freq;
      entry.qual = static_cast<int>(each.qual);
      entry.level = static_cast<int>(each.level);
      entry.noise = static_cast<int>(each.noise);
      links.push_back(entry);
    }
    return true;
  }
};

wire::Bytes BytesOf(const std::uint8_t* data, std::uint32_t count) {
  return data == nullptr ? wire::Bytes() : wire::Bytes(data, data + count);
}

std::size_t Index(int index) { return static_cast<std::size_t>(index); }

wire::BlackboardEntry KeyAndGroup(const char* key, const char* group) {
  wire::BlackboardEntry entry;
  entry.key = key;
  entry.group = group;
  return entry;
}

float Percent(std::int64_t used, std::int64_t total) {
  return total == 0 ? 0.0F : Single(100.0 * static_cast<double>(used) / static_cast<double>(total));
}

}  // namespace

// --- AioProxy

AioProxy::AioProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "AioProxy", "aio", std::make_shared<AioState>()) {}
AioProxy::~AioProxy() = default;

std::uint32_t AioProxy::GetCount() const { return Count(In<AioState>()->data.voltages); }
double AioProxy::GetVoltage(std::uint32_t index) const {
  return At(In<AioState>()->data.voltages, index, "AioProxy::GetVoltage()");
}
void AioProxy::SetVoltage(std::uint32_t index, double voltage) {
  Command(*state_, PLAYER_AIO_CMD_STATE, wire::AioCmd{index, voltage});
}
double AioProxy::operator[](std::uint32_t index) const { return GetVoltage(index); }

// --- AudioProxy

AudioProxy::AudioProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "AudioProxy", "audio", std::make_shared<AudioState>()) {}
AudioProxy::~AudioProxy() = default;

std::uint32_t AudioProxy::GetMixerDetailsCount() const {
  return Count(In<AudioState>()->details.details);
}
player_audio_mixer_channel_detail_t AudioProxy::GetMixerDetails(int index) const {
  const auto state = In<AudioState>();
  At(state->details.details, Index(index), "AudioProxy::GetMixerDetails()");
  wire::AudioMixerChannelDetail& detail = state->details.details[Index(index)];
  return {static_cast<std::uint32_t>(detail.name.size() + 1), detail.name.data(), detail.caps};
}
std::uint32_t AudioProxy::GetDefaultOutputChannel() const {
  return static_cast<std::uint32_t>(In<AudioState>()->details.default_output);
}
std::uint32_t AudioProxy::GetDefaultInputChannel() const {
  return static_cast<std::uint32_t>(In<AudioState>()->details.default_input);
}
std::uint32_t AudioProxy::GetWavDataLength() const { return Count(In<AudioState>()->wav.data); }
void AudioProxy::GetWavData(std::uint8_t* data) const {
  const auto state = In<AudioState>();
  std::copy(state->wav.data.begin(), state->wav.data.end(), data);
}
std::uint32_t AudioProxy::GetSeqCount() const { return Count(In<AudioState>()->seq.tones); }
player_audio_seq_item_t AudioProxy::GetSeqItem(int index) const {
  const auto state = In<AudioState>();
  const wire::AudioSeqItem& item = At(state->seq.tones, Index(index), "AudioProxy::GetSeqItem()");
  return {Single(item.freq), Single(item.duration), Single(item.amplitude), {item.link.state}};
}
std::uint32_t AudioProxy::GetChannelCount() const {
  return Count(In<AudioState>()->channels.channels);
}
player_audio_mixer_channel_t AudioProxy::GetChannel(int index) const {
  const auto state = In<AudioState>();
  const wire::AudioMixerChannel& channel =
      At(state->channels.channels, Index(index), "AudioProxy::GetChannel()");
  return {Single(channel.amplitude), {channel.active.state}, channel.index};
}
std::uint32_t AudioProxy::GetState() const { return In<AudioState>()->state.state; }
void AudioProxy::PlayWav(std::uint32_t data_count, std::uint8_t* data, std::uint32_t format) {
  Command(*state_, PLAYER_AUDIO_CMD_WAV_PLAY, wire::AudioWav{BytesOf(data, data_count), format});
}
void AudioProxy::SetWavStremRec(bool state) {
  Command(*state_, PLAYER_AUDIO_CMD_WAV_STREAM_REC, wire::Bool{Flag(state)});
}
void AudioProxy::PlaySample(int index) {
  Command(*state_, PLAYER_AUDIO_CMD_SAMPLE_PLAY, wire::AudioSampleItem{index});
}
void AudioProxy::PlaySeq(player_audio_seq_t* tones) {
  wire::AudioSeq seq;
  for (std::uint32_t i = 0; i < tones->tones_count; ++i) {
    const player_audio_seq_item_t& tone = tones->tones[i];
    seq.tones.push_back({tone.freq, tone.duration, tone.amplitude, {tone.link.state}});
  }
  Command(*state_, PLAYER_AUDIO_CMD_SEQ_PLAY, seq);
}
void AudioProxy::SetMultMixerLevels(player_audio_mixer_channel_list_t* levels) {
  wire::AudioMixerChannelList list;
  for (std::uint32_t i = 0; i < levels->channels_count; ++i) {
    const player_audio_mixer_channel_t& channel = levels->channels[i];
    list.channels.push_back({channel.amplitude, {channel.active.state}, channel.index});
  }
  Command(*state_, PLAYER_AUDIO_CMD_MIXER_CHANNEL, list);
}
void AudioProxy::SetMixerLevel(std::uint32_t index, float amplitude, std::uint8_t active) {
  wire::AudioMixerChannelList list;
  list.channels.push_back({amplitude, {active}, index});
  Command(*state_, PLAYER_AUDIO_CMD_MIXER_CHANNEL, list);
}
void AudioProxy::RecordWav() {
  wire::AudioWav wav;
  Require(AskFor(*state_, PLAYER_AUDIO_REQ_WAV_REC, wav), "AudioProxy::RecordWav()");
  In<AudioState>()->wav = std::move(wav);
}
void AudioProxy::LoadSample(int index, std::uint32_t data_count, std::uint8_t* data,
                            std::uint32_t format) {
  Require(Ask(*state_, PLAYER_AUDIO_REQ_SAMPLE_LOAD,
              wire::AudioSample{{BytesOf(data, data_count), format}, index}),
          "AudioProxy::LoadSample()");
}
void AudioProxy::GetSample(int index) {
  const wire::AudioSample asked{{}, index};
  wire::AudioSample sample;
  Require(AskFor(*state_, PLAYER_AUDIO_REQ_SAMPLE_RETRIEVE, wire::Body::Of(asked), sample),
          "AudioProxy::GetSample()");
  In<AudioState>()->wav = std::move(sample.sample);
}
void AudioProxy::RecordSample(int index, std::uint32_t length) {
  Require(Ask(*state_, PLAYER_AUDIO_REQ_SAMPLE_REC, wire::AudioSampleRecReq{index, length}),
          "AudioProxy::RecordSample()");
}
void AudioProxy::GetMixerLevels() {
  wire::AudioMixerChannelList channels;
  Require(AskFor(*state_, PLAYER_AUDIO_REQ_MIXER_CHANNEL_LEVEL, channels),
          "AudioProxy::GetMixerLevels()");
  In<AudioState>()->channels = std::move(channels);
}
void AudioProxy::GetMixerDetails() {
  wire::AudioMixerChannelListDetail details;
  Require(AskFor(*state_, PLAYER_AUDIO_REQ_MIXER_CHANNEL_LIST, details),
          "AudioProxy::GetMixerDetails()");
  In<AudioState>()->details = std::move(details);
}

// --- BlackBoardProxy

BlackBoardProxy::BlackBoardProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "BlackBoardProxy", "blackboard",
                  std::make_shared<BlackBoardState>()) {
  In<BlackBoardState>()->board.addr = {0, 0, PLAYER_BLACKBOARD_CODE,
                                       static_cast<std::uint16_t>(index)};
}
BlackBoardProxy::~BlackBoardProxy() = default;

player_blackboard_entry_t* BlackBoardProxy::SubscribeToKey(const char* key, const char* group) {
  const wire::BlackboardEntry asked = KeyAndGroup(key, group);
  wire::BlackboardEntry entry;
  Require(AskFor(*state_, PLAYER_BLACKBOARD_REQ_SUBSCRIBE_TO_KEY, wire::Body::Of(asked), entry),
          "BlackBoardProxy::SubscribeToKey()");
  return &In<BlackBoardState>()->given.emplace_back(std::move(entry)).c;
}
void BlackBoardProxy::UnsubscribeFromKey(const char* key, const char* group) {
  Require(Ask(*state_, PLAYER_BLACKBOARD_REQ_UNSUBSCRIBE_FROM_KEY, KeyAndGroup(key, group)),
          "BlackBoardProxy::UnsubscribeFromKey()");
}
void BlackBoardProxy::SubscribeToGroup(const char* key) {
  Require(Ask(*state_, PLAYER_BLACKBOARD_REQ_SUBSCRIBE_TO_GROUP, KeyAndGroup("", key)),
          "BlackBoardProxy::SubscribeToGroup()");
}
void BlackBoardProxy::UnsubscribeFromGroup(const char* group) {
  Require(Ask(*state_, PLAYER_BLACKBOARD_REQ_UNSUBSCRIBE_FROM_GROUP, KeyAndGroup("", group)),
          "BlackBoardProxy::UnsubscribeFromGroup()");
}
void BlackBoardProxy::SetEntry(const player_blackboard_entry_t& entry) {
  wire::BlackboardEntry sent =
      KeyAndGroup(entry.key == nullptr ? "" : entry.key, entry.group == nullptr ? "" : entry.group);
  sent.type = entry.type;
  sent.subtype = entry.subtype;
  sent.data = BytesOf(entry.data, entry.data_count);
  sent.timestamp_sec = entry.timestamp_sec;
  sent.timestamp_usec = entry.timestamp_usec;
  Require(Ask(*state_, PLAYER_BLACKBOARD_REQ_SET_ENTRY, sent), "BlackBoardProxy::SetEntry()");
}
player_blackboard_entry_t* BlackBoardProxy::GetEntry(const char* key, const char* group) {
  const wire::BlackboardEntry asked = KeyAndGroup(key, group);
  wire::BlackboardEntry entry;
  Require(AskFor(*state_, PLAYER_BLACKBOARD_REQ_GET_ENTRY, wire::Body::Of(asked), entry),
          "BlackBoardProxy::GetEntry()");
  return &In<BlackBoardState>()->given.emplace_back(std::move(entry)).c;
}
void BlackBoardProxy::SetEventHandler(void (*handler)(playerc_blackboard_t*,
                                                      player_blackboard_entry_t)) {
  In<BlackBoardState>()->handler = handler;
}

// --- CoopObjectProxy

CoopObjectProxy::CoopObjectProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "CoopObjectProxy", "coopobject",
                  std::make_shared<CoopObjectState>()) {}
CoopObjectProxy::~CoopObjectProxy() = default;

int CoopObjectProxy::MessageType() const { return In<CoopObjectState>()->kind; }
std::uint32_t CoopObjectProxy::GetOrigin() const { return In<CoopObjectState>()->header.origin; }
std::uint32_t CoopObjectProxy::GetID() const { return In<CoopObjectState>()->header.id; }
std::uint32_t CoopObjectProxy::GetParentID() const {
  return In<CoopObjectState>()->header.parent_id;
}
std::uint32_t CoopObjectProxy::GetProxyID() const { return In<CoopObjectState>()->proxy_id; }
void CoopObjectProxy::SetProxyID(std::uint32_t value) { In<CoopObjectState>()->proxy_id = value; }
std::uint32_t CoopObjectProxy::GetSensorNumber() const {
  return Count(In<CoopObjectState>()->sensors.data);
}
std::uint8_t CoopObjectProxy::GetSensorType(std::uint32_t index) const {
  return At(In<CoopObjectState>()->sensors.data, index, "CoopObjectProxy::GetSensorType()").type;
}
std::uint16_t CoopObjectProxy::GetSensorData(std::uint32_t index) const {
  return static_cast<std::uint16_t>(
      At(In<CoopObjectState>()->sensors.data, index, "CoopObjectProxy::GetSensorData()").value);
}
std::uint32_t CoopObjectProxy::GetAlarmNumber() const {
  return Count(In<CoopObjectState>()->alarms.data);
}
std::uint8_t CoopObjectProxy::GetAlarmType(std::uint32_t index) const {
  return At(In<CoopObjectState>()->alarms.data, index, "CoopObjectProxy::GetAlarmType()").type;
}
std::uint16_t CoopObjectProxy::GetAlarmData(std::uint32_t index) const {
  return static_cast<std::uint16_t>(
      At(In<CoopObjectState>()->alarms.data, index, "CoopObjectProxy::GetAlarmData()").value);
}
std::uint32_t CoopObjectProxy::GetUserDataNumber() const {
  return Count(In<CoopObjectState>()->user.data);
}
std::uint8_t* CoopObjectProxy::GetAllUserData() const {
  return In<CoopObjectState>()->user.data.data();
}
std::uint8_t CoopObjectProxy::GetUserData(std::uint32_t index) const {
  return At(In<CoopObjectState>()->user.data, index, "CoopObjectProxy::GetUserData()");
}
std::uint16_t CoopObjectProxy::GetRSSIsenderId() const {
  return In<CoopObjectState>()->rssi.sender_id;
}
std::uint16_t CoopObjectProxy::GetRSSIvalue() const { return In<CoopObjectState>()->rssi.rssi; }
std::uint16_t CoopObjectProxy::GetRSSIstamp() const { return In<CoopObjectState>()->rssi.stamp; }
double CoopObjectProxy::GetRSSInodeTime() const {
  const auto state = In<CoopObjectState>();
  return state->rssi.nodeTimeHigh + state->rssi.nodeTimeLow * 1e-6;
}
float CoopObjectProxy::GetX() const {
  const auto state = In<CoopObjectState>();
  return Single(state->kind == PLAYER_COOPOBJECT_MSG_RSSI ? state->rssi.x : state->position.x);
}
float CoopObjectProxy::GetY() const {
  const auto state = In<CoopObjectState>();
  return Single(state->kind == PLAYER_COOPOBJECT_MSG_RSSI ? state->rssi.y : state->position.y);
}
float CoopObjectProxy::GetZ() const {
  const auto state = In<CoopObjectState>();
  return Single(state->kind == PLAYER_COOPOBJECT_MSG_RSSI ? state->rssi.z : state->position.z);
}
std::uint8_t CoopObjectProxy::GetStatus() const { return In<CoopObjectState>()->position.status; }
std::uint32_t CoopObjectProxy::GetRequest() const { return In<CoopObjectState>()->request.request; }
std::uint32_t CoopObjectProxy::GetCommand() const { return In<CoopObjectState>()->command.command; }
std::uint32_t CoopObjectProxy::GetParametersSize() const {
  return Count(In<CoopObjectState>()->parameters);
}
std::uint8_t* CoopObjectProxy::GetAllParameters() const {
  return In<CoopObjectState>()->parameters.data();
}
std::uint8_t CoopObjectProxy::GetParameter(std::uint32_t index) const {
  return At(In<CoopObjectState>()->parameters, index, "CoopObjectProxy::GetParameter()");
}

namespace {

// Who a message to a cooperating object is for, and whom it is from.
wire::CoopobjectHeader HeaderTo(int dest_id, int source_id) {
  return {PLAYER_COOPOBJECT_ORIGIN_ROBOT, static_cast<std::uint16_t>(dest_id),
          static_cast<std::uint16_t>(source_id)};
}

}  // namespace

void CoopObjectProxy::SendData(int dest_id, int source_id, player_pose2d_t pos, int status) {
  Command(*state_, PLAYER_COOPOBJECT_CMD_POSITION,
          wire::CoopobjectPosition{HeaderTo(dest_id, source_id), pos.px, pos.py, pos.pa,
                                   static_cast<std::uint8_t>(status)});
}
void CoopObjectProxy::SendData(int dest_id, int source_id, int extradata_type,
                               std::uint32_t extradata_size, std::uint8_t* extradata) {
  Command(*state_, PLAYER_COOPOBJECT_CMD_DATA,
          wire::CoopobjectDataUserdefined{HeaderTo(dest_id, source_id),
                                          static_cast<std::uint8_t>(extradata_type),
                                          BytesOf(extradata, extradata_size)});
}
void CoopObjectProxy::SendCommand(int dest_id, int source_id, int command,
                                  std::uint32_t cmd_parameters_size, std::uint8_t* cmd_parameters) {
  Command(*state_, PLAYER_COOPOBJECT_CMD_STANDARD,
          wire::CoopobjectCmd{HeaderTo(dest_id, source_id), static_cast<std::uint8_t>(command),
                              BytesOf(cmd_parameters, cmd_parameters_size)});
}
void CoopObjectProxy::SendRequest(int dest_id, int source_id, int request,
                                  std::uint32_t req_parameters_size, std::uint8_t* req_parameters) {
  Require(Ask(*state_, PLAYER_COOPOBJECT_REQ_STANDARD,
              wire::CoopobjectReq{HeaderTo(dest_id, source_id), static_cast<std::uint8_t>(request),
                                  BytesOf(req_parameters, req_parameters_size)}),
          "CoopObjectProxy::SendRequest()");
}

// --- DioProxy

DioProxy::DioProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "DioProxy", "dio", std::make_shared<DioState>()) {}
DioProxy::~DioProxy() = default;

std::uint32_t DioProxy::GetCount() const { return In<DioState>()->data.count; }
std::uint32_t DioProxy::GetDigin() const { return In<DioState>()->data.bits; }
bool DioProxy::GetInput(std::uint32_t index) const {
  return index < 32 && (GetDigin() >> index & 1U) != 0;
}
void DioProxy::SetOutput(std::uint32_t count, std::uint32_t digout) {
  Command(*state_, PLAYER_DIO_CMD_VALUES, wire::DioCmd{count, digout});
}
std::uint32_t DioProxy::operator[](std::uint32_t index) const { return GetInput(index) ? 1 : 0; }

// --- HealthProxy

HealthProxy::HealthProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "HealthProxy", "health", std::make_shared<HealthState>()) {}
HealthProxy::~HealthProxy() = default;

float HealthProxy::GetIdleCPU() { return Single(In<HealthState>()->data.cpu_usage.idle); }
float HealthProxy::GetSystemCPU() { return Single(In<HealthState>()->data.cpu_usage.system); }
float HealthProxy::GetUserCPU() { return Single(In<HealthState>()->data.cpu_usage.user); }
std::int64_t HealthProxy::GetMemTotal() { return In<HealthState>()->data.mem.total; }
std::int64_t HealthProxy::GetMemUsed() { return In<HealthState>()->data.mem.used; }
std::int64_t HealthProxy::GetMemFree() { return In<HealthState>()->data.mem.free; }
std::int64_t HealthProxy::GetSwapTotal() { return In<HealthState>()->data.swap.total; }
std::int64_t HealthProxy::GetSwapUsed() { return In<HealthState>()->data.swap.used; }
std::int64_t HealthProxy::GetSwapFree() { return In<HealthState>()->data.swap.free; }
float HealthProxy::GetPercMemUsed() {
  const wire::HealthMemory mem = In<HealthState>()->data.mem;
  return Percent(mem.used, mem.total);
}
float HealthProxy::GetPercSwapUsed() {
  const wire::HealthMemory swap = In<HealthState>()->data.swap;
  return Percent(swap.used, swap.total);
}
float HealthProxy::GetPercTotalUsed() {
  const wire::HealthData data = In<HealthState>()->data;
  return Percent(data.mem.used + data.swap.used, data.mem.total + data.swap.total);
}

// --- LinuxjoystickProxy

LinuxjoystickProxy::LinuxjoystickProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "LinuxjoystickProxy", "joystick",
                  std::make_shared<JoystickState>()) {}
LinuxjoystickProxy::~LinuxjoystickProxy() = default;

std::uint32_t LinuxjoystickProxy::GetButtons() const { return In<JoystickState>()->data.buttons; }
double LinuxjoystickProxy::GetAxes(std::uint32_t index) const {
  const auto state = In<JoystickState>();
  return index < std::min<std::size_t>(state->data.axes_count, state->data.pos.size())
             ? state->data.pos[index]
             : -1.0;
}
double LinuxjoystickProxy::operator[](std::uint32_t index) const { return GetAxes(index); }
std::uint32_t LinuxjoystickProxy::GetAxesCount() const {
  return In<JoystickState>()->data.axes_count;
}

// --- LogProxy

LogProxy::LogProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "LogProxy", "log", std::make_shared<LogState>()) {}
LogProxy::~LogProxy() = default;

int LogProxy::GetType() const { return In<LogState>()->log.type; }
int LogProxy::GetState() const { return In<LogState>()->log.state; }
void LogProxy::QueryState() {
  wire::LogGetState log;
  Require(AskFor(*state_, PLAYER_LOG_REQ_GET_STATE, log), "LogProxy::QueryState()");
  In<LogState>()->log = log;
}
void LogProxy::SetState(int state) {
  if (GetType() == 0) QueryState();
  if (GetType() == PLAYER_LOG_TYPE_READ) {
    SetReadState(state);
  } else {
    SetWriteState(state);
  }
}
void LogProxy::SetWriteState(int state) {
  Require(Ask(*state_, PLAYER_LOG_REQ_SET_WRITE_STATE, wire::LogSetWriteState{Flag(state != 0)}),
          "LogProxy::SetWriteState()");
}
void LogProxy::SetReadState(int state) {
  Require(Ask(*state_, PLAYER_LOG_REQ_SET_READ_STATE, wire::LogSetReadState{Flag(state != 0)}),
          "LogProxy::SetReadState()");
}
void LogProxy::Rewind() {
  Require(Ask(*state_, PLAYER_LOG_REQ_SET_READ_REWIND), "LogProxy::Rewind()");
}
// NOLINTNEXTLINE(performance-unnecessary-value-param): Player's own type
void LogProxy::SetFilename(const std::string filename) {
  Require(Ask(*state_, PLAYER_LOG_REQ_SET_FILENAME, wire::LogSetFilename{filename}),
          "LogProxy::SetFilename()");
}

// --- OpaqueProxy

OpaqueProxy::OpaqueProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "OpaqueProxy", "opaque", std::make_shared<OpaqueState>()) {}
OpaqueProxy::~OpaqueProxy() = default;

std::uint32_t OpaqueProxy::GetCount() const { return Count(In<OpaqueState>()->data.data); }
void OpaqueProxy::GetData(std::uint8_t* dest) const {
  const auto state = In<OpaqueState>();
  std::copy(state->data.data.begin(), state->data.data.end(), dest);
}
void OpaqueProxy::SendCmd(player_opaque_data_t* data) {
  Command(*state_, PLAYER_OPAQUE_CMD_DATA, wire::OpaqueData{BytesOf(data->data, data->data_count)});
}
int OpaqueProxy::SendReq(player_opaque_data_t* request) {
  const wire::OpaqueData asked{BytesOf(request->data, request->data_count)};
  wire::OpaqueData reply;
  if (!AskFor(*state_, PLAYER_OPAQUE_REQ_DATA, wire::Body::Of(asked), reply).ok()) return -1;
  In<OpaqueState>()->data = std::move(reply);
  return 0;
}

// --- PowerProxy

PowerProxy::PowerProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "PowerProxy", "power", std::make_shared<PowerState>()) {}
PowerProxy::~PowerProxy() = default;

double PowerProxy::GetCharge() const { return In<PowerState>()->data.volts; }
double PowerProxy::GetPercent() const { return In<PowerState>()->data.percent; }
double PowerProxy::GetJoules() const { return In<PowerState>()->data.joules; }
double PowerProxy::GetWatts() const { return In<PowerState>()->data.watts; }
bool PowerProxy::GetCharging() const { return In<PowerState>()->data.charging != 0; }
bool PowerProxy::IsValid() const { return In<PowerState>()->data.valid != 0; }

// --- RFIDProxy

RFIDProxy::RFIDProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "RFIDProxy", "rfid", std::make_shared<RfidState>()) {}
RFIDProxy::~RFIDProxy() = default;

std::uint32_t RFIDProxy::GetTagsCount() const { return Count(In<RfidState>()->data.tags); }
playerc_rfidtag_t RFIDProxy::GetRFIDTag(std::uint32_t index) const {
  const auto state = In<RfidState>();
  At(state->data.tags, index, "RFIDProxy::GetRFIDTag()");
  wire::RfidTag& tag = state->data.tags[index];
  return {tag.type, Count(tag.guid), tag.guid.data()};
}
playerc_rfidtag_t RFIDProxy::operator[](std::uint32_t index) const { return GetRFIDTag(index); }

// --- SpeechProxy

SpeechProxy::SpeechProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "SpeechProxy", "speech", std::make_shared<NoState>()) {}
SpeechProxy::~SpeechProxy() = default;

void SpeechProxy::Say(std::string str) {
  Command(*state_, PLAYER_SPEECH_CMD_SAY, wire::SpeechCmd{std::move(str)});
}

// --- SpeechRecognitionProxy

SpeechRecognitionProxy::SpeechRecognitionProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "SpeechRecognitionProxy", "speech_recognition",
                  std::make_shared<WordsState>()) {}
SpeechRecognitionProxy::~SpeechRecognitionProxy() = default;

std::string SpeechRecognitionProxy::GetWord(std::uint32_t word) const {
  return At(In<WordsState>()->words, word, "SpeechRecognitionProxy::GetWord()");
}
std::uint32_t SpeechRecognitionProxy::GetCount() const { return Count(In<WordsState>()->words); }
std::string SpeechRecognitionProxy::operator[](std::uint32_t word) { return GetWord(word); }

// --- WiFiProxy

WiFiProxy::WiFiProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "WiFiProxy", "wifi", std::make_shared<WifiState>()) {}
WiFiProxy::~WiFiProxy() = default;

namespace {

playerc_wifi_link_t& Link(WifiState& state, int index, const char* function) {
  At(state.links, Index(index), function);
  return state.links[Index(index)];
}

}  // namespace

const playerc_wifi_link_t* WiFiProxy::GetLink(int link) {
  return &Link(*In<WifiState>(), link, "WiFiProxy::GetLink()");
}
int WiFiProxy::GetLinkCount() const { return static_cast<int>(In<WifiState>()->links.size()); }
char* WiFiProxy::GetOwnIP() const { return In<WifiState>()->ip.data(); }
char* WiFiProxy::GetLinkIP(int index) const {
  return Link(*In<WifiState>(), index, "WiFiProxy::GetLinkIP()").ip;
}
char* WiFiProxy::GetLinkMAC(int index) const {
  return Link(*In<WifiState>(), index, "WiFiProxy::GetLinkMAC()").mac;
}
char* WiFiProxy::GetLinkESSID(int index) const {
  return Link(*In<WifiState>(), index, "WiFiProxy::GetLinkESSID()").essid;
}
double WiFiProxy::GetLinkFreq(int index) const {
  return Link(*In<WifiState>(), index, "WiFiProxy::GetLinkFreq()").freq;
}
int WiFiProxy::GetLinkMode(int index) const {
  return Link(*In<WifiState>(), index, "WiFiProxy::GetLinkMode()").mode;
}
int WiFiProxy::GetLinkEncrypt(int index) const {
  return Link(*In<WifiState>(), index, "WiFiProxy::GetLinkEncrypt()").encrypt;
}
int WiFiProxy::GetLinkQuality(int index) const {
  return Link(*In<WifiState>(), index, "WiFiProxy::GetLinkQuality()").qual;
}
int WiFiProxy::GetLinkLevel(int index) const {
  return Link(*In<WifiState>(), index, "WiFiProxy::GetLinkLevel()").level;
}
int WiFiProxy::GetLinkNoise(int index) const {
  return Link(*In<WifiState>(), index, "WiFiProxy::GetLinkNoise()").noise;
}

// --- WSNProxy

WSNProxy::WSNProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "WSNProxy", "wsn", std::make_shared<WsnState>()) {}
WSNProxy::~WSNProxy() = default;

std::uint32_t WSNProxy::GetNodeType() const { return In<WsnState>()->data.node_type; }
std::uint32_t WSNProxy::GetNodeID() const { return In<WsnState>()->data.node_id; }
std::uint32_t WSNProxy::GetNodeParentID() const { return In<WsnState>()->data.node_parent_id; }
player_wsn_node_data_t WSNProxy::GetNodeDataPacket() const {
  const wire::WsnNodeData data = In<WsnState>()->data.data_packet;
  return {Single(data.light),       Single(data.mic),    Single(data.accel_x), Single(data.accel_y),
          Single(data.accel_z),     Single(data.magn_x), Single(data.magn_y),  Single(data.magn_z),
          Single(data.temperature), Single(data.battery)};
}
void WSNProxy::SetDevState(int node_id, int group_id, int dev_nr, int value) {
  Command(*state_, PLAYER_WSN_CMD_DEVSTATE,
          wire::WsnCmd{node_id, group_id, static_cast<std::uint32_t>(dev_nr),
                       static_cast<std::uint8_t>(value)});
}
void WSNProxy::Power(int node_id, int group_id, int value) {
  Require(Ask(*state_, PLAYER_WSN_REQ_POWER,
              wire::WsnPowerConfig{node_id, group_id, static_cast<std::uint8_t>(value)}),
          "WSNProxy::Power()");
}
void WSNProxy::DataType(int value) {
  Require(Ask(*state_, PLAYER_WSN_REQ_DATATYPE,
              wire::WsnDatatypeConfig{static_cast<std::uint8_t>(value)}),
          "WSNProxy::DataType()");
}
void WSNProxy::DataFreq(int node_id, int group_id, float frequency) {
  Require(
      Ask(*state_, PLAYER_WSN_REQ_DATAFREQ, wire::WsnDatafreqConfig{node_id, group_id, frequency}),
      "WSNProxy::DataFreq()");
}

}  // namespace PlayerCc
