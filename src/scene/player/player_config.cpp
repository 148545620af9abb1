#include "scene/player/player_config.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "scene/field.h"

namespace ccmorse::scene {
namespace {

std::vector<PlayerAddress> Addresses(PropertyReader& reader, const char* name) {
  std::vector<PlayerAddress> addresses;
  for (const std::string& text : reader.Texts(name)) {
    try {
      addresses.push_back(ParsePlayerAddress(text));
    } catch (const Error& error) {
      reader.At(name).Fail(error.what());
    }
  }
  return addresses;
}

Json OptionValue(const PlayerValue& value) {
  switch (value.kind) {
    case PlayerValue::Kind::kNumber:
      return value.number;
    case PlayerValue::Kind::kText:
      return value.text;
    default:
      break;
  }
  Json::Array items;
  for (const PlayerValue& item : value.items) items.push_back(OptionValue(item));
  return items;
}

ConfigDriver ReadDriver(const PlayerEntity& entity, const PlayerFile& file) {
  PropertyReader reader(entity, file);
  ConfigDriver section;
  section.at = entity.at;
  PlayerDriver& driver = section.driver;
  driver.name = reader.Text("name", "");
  if (driver.name.empty()) {
    entity.at.Fail("a driver without a name; add one, as name \"stage\"");
  }
  section.plugin = reader.Text("plugin", "");
  driver.provided = Addresses(reader, "provides");
  driver.needed = Addresses(reader, "requires");
  section.provides_at = reader.At("provides");
  driver.always_on = reader.Bool("alwayson", false);
  driver.length_unit = file.length_unit;
  driver.angle_unit = file.angle_unit;
  if (IsStage(section)) {
    section.world_file = reader.Text("worldfile", "");
    section.world_file_at = reader.At("worldfile");
    section.model = reader.Text("model", "");
    section.model_at = reader.At("model");
  }
  for (const PlayerProperty* property : reader.Unused()) {
    // Of two alike the later counts.
    const PlayerValue& value = *reader.Find(property->name);
    driver.options.emplace_back(property->name, OptionValue(value));
    driver.places.push_back(value.at.Text());
  }
  return section;
}

}  // namespace

bool IsStage(const ConfigDriver& driver) {
  return driver.driver.name == "stage" || driver.plugin == "stageplugin" ||
         driver.plugin == "libstageplugin";
}

PlayerConfig ParsePlayerConfig(const std::string& text, const std::string& file,
                               const FileReader& read) {
  const PlayerFile parsed = ParsePlayerFile(text, file, PlayerDialect::kConfig, read);
  PlayerConfig config;
  config.file = file;
  std::map<std::string, FilePlace> provided;
  for (const PlayerEntity& entity : parsed.global.children) {
    if (entity.type != "driver") {
      config.notes.push_back(
          {entity.at,
           fmt::format("section {} has no effect: only driver ( ... ) has", Quoted(entity.written)),
           true});
      continue;
    }
    config.drivers.push_back(ReadDriver(entity, parsed));
    const ConfigDriver& section = config.drivers.back();
    for (const PlayerEntity& child : entity.children) {
      config.notes.push_back(
          {child.at, fmt::format("{} within a driver has no effect", Quoted(child.written)), true});
    }
    for (const PlayerAddress& address : section.driver.provided) {
      if (!address.host.empty()) {
        section.provides_at.Fail(fmt::format(
            "{} is on another machine, which cannot be provided here; leave the host out",
            ToText(address)));
      }
      const std::string device =
          fmt::format("{}:{}:{}", address.port, address.interface, address.index);
      const auto [first, is_new] = provided.emplace(device, section.provides_at);
      if (!is_new) {
        section.provides_at.Fail(fmt::format("{} is provided on line {} already; remove one",
                                             device, first->second.line));
      }
    }
  }
  for (const PlayerProperty& property : parsed.global.properties) {
    config.notes.push_back(
        {property.value.at,
         fmt::format("{} stands outside of all drivers and has no effect", Quoted(property.name)),
         true});
  }
  return config;
}

}  // namespace ccmorse::scene
