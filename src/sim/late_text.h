#pragma once

#include <functional>
#include <string>

namespace ccmorse::sim {

/// Of a component whose data are long: they can be put into words later, and by another thread than
/// the simulation's, for which that would take too long.
class LateText {
 public:
  virtual ~LateText() = default;
  /// Copies the data as they are now. The function says what LocalData() would have said now; it
  /// may be called on any thread, once the component has gone, too.
  virtual std::function<std::string()> TextLater() = 0;
};

}  // namespace ccmorse::sim
