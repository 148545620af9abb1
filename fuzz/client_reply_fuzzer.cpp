// MorseValue: what the client library makes of the value in a simulator's reply. The input: a line
// with a path, then the value's text. What must hold:
// - Parse() gives a value or a MorseError of one line;
// - no getter throws, whatever path it is given, and each gives its fallback or what the value's
//   type allows;
// - what a value says of itself agrees: its type, its size, its keys and its elements;
// - ToString() is one line that parses to a value with the same text;
// - a pose read from it is finite.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "client/morse/read_pose.h"
#include "fuzz/check.h"
#include "libCCMorse/MorseError.h"
#include "libCCMorse/MorseValue.h"

namespace {

using CCMorse::MorseValue;
using ccmorse::fuzz::Require;

void CheckGetters(const MorseValue& value, const std::string& path) {
  const bool has = value.Has(path);
  const MorseValue found = value.Get(path);
  Require(has || found.IsNull(), "a path that leads nowhere gives null");
  const double number = value.GetDouble(path, -7.5);
  Require(found.IsNumber() || number == -7.5, "what is no number gives the fallback");
  const int whole = value.GetInt(path, -7);
  Require(!found.IsNumber() ? whole == -7
                            : std::isnan(number) || std::fabs(number) > 2147483647.0 ||
                                  std::fabs(number - whole) < 1.0,
          "GetInt() cuts a number");
  Require(found.IsString() || value.GetString(path, "none") == "none",
          "what is no text gives the fallback");
  if (found.IsNumber() || found.IsString()) {
    Require(value.GetBool(path, true), "what is no truth value gives the fallback");
  }
  const std::size_t size = value.GetSize(path);
  Require(size == 0 || found.IsList() || found.IsObject(), "only lists and objects have a size");
  const std::size_t numbers = value.GetDoubles(path).size();
  const std::size_t texts = value.GetStrings(path).size();
  Require(numbers == 0 || numbers == size, "all of a list are numbers, or none are given");
  Require(texts == 0 || texts == size, "all of a list are texts, or none are given");
  Require(value.GetKeys(path).size() == (found.IsObject() ? size : 0), "every member has a key");
}

void CheckValue(const MorseValue& value) {
  Require(int{value.IsNull()} + int{value.IsNumber()} + int{value.IsString()} +
                  int{value.IsList()} + int{value.IsObject()} <=
              1,
          "a value has one type");
  CheckGetters(value, "");
  if (const auto pose = CCMorse::ReadPose(value, CCMorse::kPoseKeys)) {
    Require(std::isfinite(pose->px + pose->py + pose->pz) || std::fabs(pose->px) > 1e300 ||
                std::fabs(pose->py) > 1e300 || std::fabs(pose->pz) > 1e300,
            "a pose is finite");
    Require(std::isfinite(pose->proll) && std::isfinite(pose->ppitch) && std::isfinite(pose->pyaw),
            "a pose is finite");
  }
  if (value.IsList()) {
    for (std::size_t i = 0; i < value.GetSize(); ++i) {
      Require(value.Has(std::to_string(i)), "every position of a list has a value");
      CheckValue(value.At(i));
    }
    Require(value.At(value.GetSize()).IsNull(), "there is nothing beyond a list's end");
  }
  for (const std::string& key : value.GetKeys()) CheckValue(value.Member(key));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(data, data + size);
  const std::size_t end = input.find('\n');
  const std::string path = input.substr(0, end);
  const std::string text = end == std::string::npos ? "" : input.substr(end + 1);
  MorseValue value;
  try {
    value = MorseValue::Parse(text);
  } catch (const CCMorse::MorseError& error) {
    const std::string what = error.what();
    Require(what.find('\n') == std::string::npos, "a MorseError is one line", what);
    Require(error.GetErrorFun() == "MorseValue::Parse()", "a MorseError names its function", what);
    return 0;
  }
  CheckGetters(value, path);
  const MorseValue part = value.Get(path);
  const std::string dump = value.ToString();
  Require(dump.find('\n') == std::string::npos, "a value's text is one line", dump);
  Require(MorseValue::Parse(dump).ToString() == dump, "a value's text parses to the same", dump);
  CheckValue(value);
  // A part keeps alive what it is a part of.
  value = MorseValue();
  CheckValue(part);
  return 0;
}
