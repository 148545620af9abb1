#include "sim/robots/robot_skills.h"

#include <cmath>
#include <string>

#include "sim/robots/robot.h"
#include "sim/victim.h"
#include "sim/world.h"

namespace ccmorse::sim {
namespace {

constexpr double kArmLength = 1.0;  // m

bool GrabArgument(const Json& grab) {
  if (grab.IsBool()) return grab.AsBool();
  if (grab.IsString() && grab.AsString() == "true") return true;
  if (grab.IsString() && grab.AsString() == "false") return false;
  throw WrongArgument("grab must be true or false");
}

bool TakeInHand(const Robot& robot, World& world, SceneObject& object) {
  if (object.bearer == &robot) return false;
  const std::string what = "Object '" + object.name + "'";
  if (object.robot != nullptr || !object.Is("Graspable")) {
    throw ServiceFailed(what + " is not graspable");
  }
  if (object.held()) throw ServiceFailed(what + " is held by another");
  for (const SceneObject& other : world.objects().all()) {
    if (other.bearer == &robot) {
      throw ServiceFailed(robot.name() + " holds '" + other.name + "' already");
    }
  }
  const Vec3 way = object.WorldPosition() - robot.position();
  if (std::hypot(way.x, way.y) > kArmLength) throw ServiceFailed(what + " is out of reach");
  SceneObjects::SetBearer(object, &robot);
  return true;
}

Service GraspService(Robot& robot, World& world) {
  return {"grasp", {{"grab"}, {"obj_name"}}, [&robot, &world](Arguments arguments) {
            const bool grab = GrabArgument(arguments[0]);
            const std::string& name = StringArgument(arguments, 1, "obj_name");
            SceneObject* const object = world.objects().Find(name);
            if (object == nullptr) {
              throw ServiceFailed("Object '" + name + "' does not appear in the scene.");
            }
            if (grab) return Json(TakeInHand(robot, world, *object));
            if (object->bearer != &robot) return Json(false);
            SceneObjects::SetBearer(*object, nullptr);
            return Json(true);
          }};
}

Service HealService(const Robot& robot, World& world) {
  return {"heal", {}, [&robot, &world](Arguments) {
            Heal(*world.objects().Find(robot.name()));
            return Json();
          }};
}

}  // namespace

std::vector<Service> RobotSkills(Robot& robot, World& world) {
  std::vector<Service> services;
  for (const std::string& skill : robot.def().skills) {
    services.push_back(skill == "heal" ? HealService(robot, world) : GraspService(robot, world));
  }
  return services;
}

}  // namespace ccmorse::sim
