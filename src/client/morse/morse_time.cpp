#include <cmath>

#include "libCCMorse/MorseTime.h"

namespace CCMorse {

MorseTime::MorseTime(MorseClient& client) : client_(client.shared_from_this()) {}

double MorseTime::GetTime() const { return client_->Request("time", "now").GetDouble(""); }
double MorseTime::GetLastReadTime() const { return client_->GetTime(); }
std::string MorseTime::GetMode() const { return client_->Request("time", "mode").GetString(""); }

MorseTimeStatistics MorseTime::GetStatistics() const {
  const MorseValue answer = client_->Request("time", "statistics");
  MorseTimeStatistics statistics;
  statistics.mean_time = answer.GetDouble("mean_time");
  statistics.variance_time = answer.GetDouble("variance_time");
  statistics.mean_frame_by_sec = answer.GetDouble("mean_frame_by_sec");
  statistics.variance_frame_by_sec = answer.GetDouble("variance_frame_by_sec");
  statistics.diff_real_time = answer.GetDouble("diff_real_time");
  return statistics;
}

bool MorseTime::SetTimeScale(double factor) {
  if (!std::isfinite(factor) || factor <= 0.0) {
    throw MorseError("a time scale is above 0", "MorseTime::SetTimeScale()");
  }
  return client_->Request("time", "set_time_scale", MorseArgs(factor)).IsTrue();
}

}  // namespace CCMorse
