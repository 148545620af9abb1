#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "scene/scenario.h"
#include "servers/own/code_host.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// Runs the components that are plug-ins of C++ (include/ccmorse/plugin.h), in this process: their
/// exceptions end them, their crashes end us.
class PluginHost : public CodeHost {
 public:
  /// Opens each component's file and makes its component, which it gives to `taker`. Throws Error
  /// as DescribePlugins() does.
  PluginHost(sim::Simulation& simulation, const std::vector<sim::OwnComponent*>& components,
             const Taker& taker);
  ~PluginHost() override;

  void Perform(std::span<const OwnTask> tasks, const Taker& taker) override;

  /// What the plug-in of a file says of its component, see DescribePlugins().
  static void Describe(const std::string& file, scene::ComponentDef& component);

 private:
  class Part;
  std::map<const sim::OwnComponent*, std::unique_ptr<Part>> parts_;
};

/// Fills in what a scenario's plug-ins say of themselves: kind, type, data, properties and
/// services. Throws Error that names the file: it cannot be loaded, is no plug-in, or was built for
/// another version of the interface.
void DescribePlugins(scene::Scenario& scenario);

}  // namespace ccmorse::servers
