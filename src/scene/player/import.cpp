#include "scene/player/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "assets/load.h"
#include "base/nearest_name.h"
#include "scene/asset_world.h"
#include "scene/field.h"

namespace ccmorse::scene {
namespace {

// Gives the models of a world's robots to the devices that a .cfg asks for (specs: player.md C.2):
// each interface gets the first model of its type, in pre-order, that no other has.
class Binder {
 public:
  Binder(const std::vector<StageRobot>& robots, ImportedScenario& imported)
      : robots_(robots), imported_(imported) {}

  void Bind(const ConfigDriver& section) {
    const StageRobot* const robot = section.model.empty() ? nullptr : Find(section);
    for (const PlayerAddress& address : section.driver.provided) {
      PlayerDevice device{address.port, address.interface, address.index, "", ""};
      if (address.interface == "simulation") {
        Add(device);
        continue;
      }
      if (robot == nullptr) {
        section.provides_at.Fail(
            fmt::format("{} is provided by no model; add model \"...\"", ToText(address)));
      }
      device.robot = robot->name;
      if (address.interface == "graphics2d") {
        Add(device);
        continue;
      }
      device.device = Take(*robot, address.interface);
      if (!device.device.empty()) {
        Add(device);
        continue;
      }
      imported_.notes.push_back({section.provides_at,
                                 fmt::format("{} is not provided: model {} has nothing left for it "
                                             "that CCMorse has",
                                             ToText(address), Quoted(section.model)),
                                 true});
    }
  }

 private:
  const StageRobot* Find(const ConfigDriver& section) const {
    std::vector<std::string> names;
    for (const StageRobot& robot : robots_) {
      if (robot.models[0].name == section.model) return &robot;
      names.push_back(robot.models[0].name);
    }
    section.model_at.Fail(
        fmt::format("{} is no position model of the world{}; {}", Quoted(section.model),
                    DidYouMean(section.model, names),
                    names.empty() ? std::string("it has none") : "it has " + Listed(names)));
  }

  // The component that serves an interface, which is then taken; "" where there is none.
  std::string Take(const StageRobot& robot, const std::string& interface) {
    const RobotDef& def =
        *std::find_if(imported_.scenario.robots.begin(), imported_.scenario.robots.end(),
                      [&robot](const RobotDef& candidate) { return candidate.name == robot.name; });
    const std::vector<std::string> able = DevicesFor(def, interface);
    for (const StageModel& model : robot.models) {
      for (const std::string& component : model.components) {
        if (std::find(able.begin(), able.end(), component) == able.end()) continue;
        if (used_.insert(robot.name + "." + component).second) return component;
      }
    }
    return "";
  }

  void Add(PlayerDevice device) { imported_.scenario.player->devices.push_back(std::move(device)); }

  const std::vector<StageRobot>& robots_;
  ImportedScenario& imported_;
  std::set<std::string> used_;
};

// The driver of SyRoTek's real robots (specs: syrotek.md A): "base" counts the wheels' turns,
// "global" is the camera above the arena.
void BindSyrotek(const ConfigDriver& section, ImportedScenario& imported) {
  const RobotDef& robot = imported.scenario.robots[0];
  for (const PlayerAddress& address : section.driver.provided) {
    PlayerDevice device{address.port, address.interface, address.index, robot.name, ""};
    const std::vector<std::string> able = DevicesFor(robot, address.interface);
    if (address.interface == "position2d") {
      device.device = address.key == "base" ? "odometry" : "pose";
    } else if (!able.empty()) {
      device.device = able[0];
    } else {
      imported.notes.push_back(
          {section.provides_at,
           fmt::format("{} is not provided: the S1R of this scenario has nothing for it",
                       ToText(address)),
           true});
      continue;
    }
    imported.scenario.player->devices.push_back(std::move(device));
  }
}

// The driver with the names of files that it reads as seen from here: the .cfg has them as seen
// from its own folder (specs: player.md C.1).
PlayerDriver WithFilesOf(const ConfigDriver& section, const std::string& config_file) {
  PlayerDriver driver = section.driver;
  if (driver.name != "mapfile" && driver.name != "readlog") return driver;
  const std::filesystem::path folder = std::filesystem::path(config_file).parent_path();
  for (auto& [name, value] : driver.options) {
    if (name != "filename" || !value.IsString()) continue;
    value = std::filesystem::absolute(folder / value.AsString()).lexically_normal().string();
  }
  return driver;
}

StageWorld LoadWorldOf(const ConfigDriver& section, const std::string& config_file,
                       const StageFiles& files) {
  const std::filesystem::path folder = std::filesystem::path(config_file).parent_path();
  const std::string path = (folder / section.world_file).lexically_normal().string();
  std::string text;
  try {
    text = files.read(path);
  } catch (const Error& error) {
    section.world_file_at.Fail(fmt::format(
        "{}; the name of the world's file starts from the folder of the .cfg", error.what()));
  }
  return ParseStageWorld(text, path, files);
}

}  // namespace

ImportedScenario ImportConfig(const PlayerConfig& config, const StageFiles& files) {
  ImportedScenario imported;
  std::vector<StageRobot> robots;
  const auto with_world =
      std::find_if(config.drivers.begin(), config.drivers.end(),
                   [](const ConfigDriver& section) { return !section.world_file.empty(); });
  const auto syrotek =
      std::find_if(config.drivers.begin(), config.drivers.end(),
                   [](const ConfigDriver& section) { return section.driver.name == "syrdriv"; });
  if (with_world != config.drivers.end()) {
    StageWorld world = LoadWorldOf(*with_world, config.file, files);
    imported.scenario = std::move(world.scenario);
    imported.notes = std::move(world.notes);
    robots = std::move(world.robots);
  } else if (syrotek != config.drivers.end()) {
    imported.scenario = ParseScenario("{}", config.file);
    imported.notes.push_back(
        {syrotek->at, "SyRoTek's real robot: simulated as an S1R in the SyRoTek arena", false});
  } else {
    FilePlace{config.file, config.drivers.empty() ? 1 : config.drivers[0].at.line}.Fail(
        "no driver names a world; add driver ( name \"stage\" provides [\"simulation:0\"] plugin "
        "\"stageplugin\" worldfile \"my.world\" )");
  }
  imported.scenario.name = std::filesystem::path(config.file).stem().string();
  imported.notes.insert(imported.notes.end(), config.notes.begin(), config.notes.end());
  imported.scenario.player.emplace();
  Binder binder(robots, imported);
  for (const ConfigDriver& section : config.drivers) {
    if (!section.world_file.empty() && &section != &*with_world) {
      section.world_file_at.Fail("a second world; there can be one");
    }
    if (section.driver.name == "syrdriv" && robots.empty()) {
      BindSyrotek(section, imported);
    } else if (IsStage(section)) {
      binder.Bind(section);
    } else {
      imported.scenario.player->drivers.push_back(WithFilesOf(section, config.file));
    }
  }
  // What it is served by, or nothing would answer its clients.
  if (imported.scenario.player->Ports().empty()) {
    FilePlace{config.file, config.drivers[0].at.line}.Fail(
        "nothing is provided; add provides [\"position2d:0\"] to a driver");
  }
  return imported;
}

ImportedScenario ImportScenario(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  if (ending == ".cfg") {
    return ImportConfig(ParsePlayerConfig(ReadFile(file), file));
  }
  if (ending == ".world") {
    StageWorld world = ParseStageWorld(ReadFile(file), file);
    return {std::move(world.scenario), std::move(world.notes)};
  }
  if (assets::IsAssetName(file)) {
    std::vector<std::string> texts;
    ImportedScenario imported;
    imported.scenario = ScenarioOfAsset(file, &texts);
    for (const std::string& text : texts) {
      FileNote& note = imported.notes.emplace_back();
      note.at.file = file;
      note.at.line = 1;
      note.text = text;
      note.matters = false;
    }
    return imported;
  }
  return {LoadScenario(file), {}};
}

}  // namespace ccmorse::scene
