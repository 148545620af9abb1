#pragma once

// Power, sound, signals, networks and data of any kind: proxies of libplayerc++ (specs: player.md
// A.4, player-interfaces.txt). What they share, errors and threads too, is said at ClientProxy.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "libplayerc++/clientproxy.h"

namespace PlayerCc {

/// Analogue inputs and outputs.
class AioProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit AioProxy(PlayerClient* client, std::uint32_t index = 0);
  ~AioProxy() override;

  std::uint32_t GetCount() const;                ///< number of elements in the last data message
  double GetVoltage(std::uint32_t index) const;  ///< V
  void SetVoltage(std::uint32_t index, double voltage);  ///< command V
  double operator[](std::uint32_t index) const;          ///< as the getter with an index
};

/// Sound, samples, tones and the mixer.
class AudioProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit AudioProxy(PlayerClient* client, std::uint32_t index = 0);
  ~AudioProxy() override;

  std::uint32_t GetMixerDetailsCount() const;
  player_audio_mixer_channel_detail_t GetMixerDetails(int index) const;
  std::uint32_t GetDefaultOutputChannel() const;
  std::uint32_t GetDefaultInputChannel() const;
  std::uint32_t GetWavDataLength() const;
  void GetWavData(std::uint8_t* data) const;
  std::uint32_t GetSeqCount() const;
  player_audio_seq_item_t GetSeqItem(int index) const;
  std::uint32_t GetChannelCount() const;
  player_audio_mixer_channel_t GetChannel(int index) const;
  std::uint32_t GetState() const;
  void PlayWav(std::uint32_t data_count, std::uint8_t* data, std::uint32_t format);
  void SetWavStremRec(bool state);
  void PlaySample(int index);
  void PlaySeq(player_audio_seq_t* tones);
  void SetMultMixerLevels(player_audio_mixer_channel_list_t* levels);
  void SetMixerLevel(std::uint32_t index, float amplitude, std::uint8_t active);
  void RecordWav();
  void LoadSample(int index, std::uint32_t data_count, std::uint8_t* data, std::uint32_t format);
  void GetSample(int index);
  void RecordSample(int index, std::uint32_t length);
  void GetMixerLevels();
  void GetMixerDetails();
};

/// Entries under keys and groups that clients of one server share. An entry that a method returns
/// belongs to the proxy and lives as long as it.
class BlackBoardProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit BlackBoardProxy(PlayerClient* client, std::uint32_t index = 0);
  ~BlackBoardProxy() override;

  player_blackboard_entry_t* SubscribeToKey(const char* key, const char* group = "");
  void UnsubscribeFromKey(const char* key, const char* group = "");
  void SubscribeToGroup(const char* key);
  void UnsubscribeFromGroup(const char* group);
  void SetEntry(const player_blackboard_entry_t& entry);
  player_blackboard_entry_t* GetEntry(const char* key, const char* group);
  void SetEventHandler(void (*handler)(playerc_blackboard_t*, player_blackboard_entry_t));
};

/// Nodes of a network of cooperating objects; getters show the last message of any kind.
class CoopObjectProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit CoopObjectProxy(PlayerClient* client, std::uint32_t index = 0);
  ~CoopObjectProxy() override;

  int MessageType() const;
  std::uint32_t GetOrigin() const;
  std::uint32_t GetID() const;
  std::uint32_t GetParentID() const;
  std::uint32_t GetProxyID() const;
  void SetProxyID(std::uint32_t value);
  std::uint32_t GetSensorNumber() const;
  std::uint8_t GetSensorType(std::uint32_t index) const;
  std::uint16_t GetSensorData(std::uint32_t index) const;
  std::uint32_t GetAlarmNumber() const;
  std::uint8_t GetAlarmType(std::uint32_t index) const;
  std::uint16_t GetAlarmData(std::uint32_t index) const;
  std::uint32_t GetUserDataNumber() const;
  std::uint8_t* GetAllUserData() const;
  std::uint8_t GetUserData(std::uint32_t index) const;
  std::uint16_t GetRSSIsenderId() const;
  std::uint16_t GetRSSIvalue() const;
  std::uint16_t GetRSSIstamp() const;
  double GetRSSInodeTime() const;
  float GetX() const;
  float GetY() const;
  float GetZ() const;
  std::uint8_t GetStatus() const;
  std::uint32_t GetRequest() const;
  std::uint32_t GetCommand() const;
  std::uint32_t GetParametersSize() const;
  std::uint8_t* GetAllParameters() const;
  std::uint8_t GetParameter(std::uint32_t index) const;
  void SendData(int dest_id, int source_id, player_pose2d_t pos, int status);
  void SendData(int dest_id, int source_id, int extradata_type, std::uint32_t extradata_size,
                std::uint8_t* extradata);
  void SendCommand(int dest_id, int source_id, int command, std::uint32_t cmd_parameters_size = 0,
                   std::uint8_t* cmd_parameters = nullptr);
  void SendRequest(int dest_id, int source_id, int request, std::uint32_t req_parameters_size = 0,
                   std::uint8_t* req_parameters = nullptr);
};

/// Digital inputs and outputs.
class DioProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit DioProxy(PlayerClient* client, std::uint32_t index = 0);
  ~DioProxy() override;

  std::uint32_t GetCount() const;            ///< number of elements in the last data message
  std::uint32_t GetDigin() const;            ///< bit field
  bool GetInput(std::uint32_t index) const;  ///< bit aIndex
  void SetOutput(std::uint32_t count, std::uint32_t digout);  ///< count, bits
  std::uint32_t operator[](std::uint32_t index) const;        ///< as the getter with an index
};

/// Load of the robot's computer: shares in percent, memory in bytes as the driver says.
class HealthProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit HealthProxy(PlayerClient* client, std::uint32_t index = 0);
  ~HealthProxy() override;

  float GetIdleCPU();
  float GetSystemCPU();
  float GetUserCPU();
  std::int64_t GetMemTotal();
  std::int64_t GetMemUsed();
  std::int64_t GetMemFree();
  std::int64_t GetSwapTotal();
  std::int64_t GetSwapUsed();
  std::int64_t GetSwapFree();
  float GetPercMemUsed();
  float GetPercSwapUsed();
  float GetPercTotalUsed();
};

/// A joystick.
class LinuxjoystickProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit LinuxjoystickProxy(PlayerClient* client, std::uint32_t index = 0);
  ~LinuxjoystickProxy() override;

  std::uint32_t GetButtons() const;  ///< bit field
  /// -1.0 if index out of range; values -32768..32767.
  double GetAxes(std::uint32_t index) const;
  double operator[](std::uint32_t index) const;  ///< as the getter with an index
  std::uint32_t GetAxesCount() const;
};

/// A recorder or player of logs.
class LogProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit LogProxy(PlayerClient* client, std::uint32_t index = 0);
  ~LogProxy() override;

  int GetType() const;   ///< 1 reader 2 writer
  int GetState() const;  ///< 0/1
  void QueryState();
  void SetState(int state);  ///< queries first if type unknown
  void SetWriteState(int state);
  void SetReadState(int state);
  void Rewind();
  void SetFilename(const std::string filename);
};

/// Bytes of any kind.
class OpaqueProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit OpaqueProxy(PlayerClient* client, std::uint32_t index = 0);
  ~OpaqueProxy() override;

  std::uint32_t GetCount() const;          ///< number of elements in the last data message
  void GetData(std::uint8_t* dest) const;  ///< copies GetCount() bytes
  void SendCmd(player_opaque_data_t* data);
  int SendReq(player_opaque_data_t* request);  ///< stores the reply as data; returns 0/-1
};

/// A battery.
class PowerProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit PowerProxy(PlayerClient* client, std::uint32_t index = 0);
  ~PowerProxy() override;

  double GetCharge() const;   ///< V
  double GetPercent() const;  ///< %
  double GetJoules() const;   ///< J
  double GetWatts() const;    ///< W
  bool GetCharging() const;
  bool IsValid() const override;  ///< any valid bit set in the last message
};

/// A reader of radio tags.
class RFIDProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit RFIDProxy(PlayerClient* client, std::uint32_t index = 0);
  ~RFIDProxy() override;

  std::uint32_t GetTagsCount() const;
  playerc_rfidtag_t GetRFIDTag(std::uint32_t index) const;
  playerc_rfidtag_t operator[](std::uint32_t index) const;  ///< as the getter with an index
};

/// A speech synthesizer.
class SpeechProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit SpeechProxy(PlayerClient* client, std::uint32_t index = 0);
  ~SpeechProxy() override;

  void Say(std::string str);  ///< command
};

/// A recognizer of speech: the words of the last sentence.
class SpeechRecognitionProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit SpeechRecognitionProxy(PlayerClient* client, std::uint32_t index = 0);
  ~SpeechRecognitionProxy() override;

  std::string GetWord(std::uint32_t word) const;
  std::uint32_t GetCount() const;              ///< number of elements in the last data message
  std::string operator[](std::uint32_t word);  ///< as the getter with an index
};

/// Wireless links. Texts that a method returns belong to the proxy and hold until its next data.
class WiFiProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit WiFiProxy(PlayerClient* client, std::uint32_t index = 0);
  ~WiFiProxy() override;

  const playerc_wifi_link_t* GetLink(int link);  ///< pointer into the proxy
  int GetLinkCount() const;
  char* GetOwnIP() const;
  char* GetLinkIP(int index) const;
  char* GetLinkMAC(int index) const;
  char* GetLinkESSID(int index) const;
  double GetLinkFreq(int index) const;  ///< MHz
  int GetLinkMode(int index) const;
  int GetLinkEncrypt(int index) const;
  int GetLinkQuality(int index) const;
  int GetLinkLevel(int index) const;
  int GetLinkNoise(int index) const;
};

/// A wireless sensor network.
class WSNProxy : public ClientProxy {
 public:
  /// Throws PlayerError when the device cannot be subscribed.
  explicit WSNProxy(PlayerClient* client, std::uint32_t index = 0);
  ~WSNProxy() override;

  std::uint32_t GetNodeType() const;
  std::uint32_t GetNodeID() const;
  std::uint32_t GetNodeParentID() const;
  player_wsn_node_data_t GetNodeDataPacket() const;
  void SetDevState(int node_id, int group_id, int dev_nr, int value);
  void Power(int node_id, int group_id, int value);
  void DataType(int value);
  void DataFreq(int node_id, int group_id, float frequency);
};

}  // namespace PlayerCc
