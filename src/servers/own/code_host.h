#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "base/json.h"
#include "sim/own/own_component.h"
#include "sim/service.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// A user's class that offers the services of a component under another name: MORSE's overlay
/// (specs: morse.md C.8). It has no part in the simulation: like a client's, the calls that it
/// makes are inputs of the run.
struct Overlay {
  const scene::OverlayDef* def = nullptr;
  sim::Component* overlaid = nullptr;
  sim::OwnComponent* own = nullptr;  ///< the same, where its code runs in the overlay's process
  std::string key;                   ///< by which it is known in messages and the log
  std::string name;                  ///< by which clients call it; "" until it has been made
  bool off = false;                  ///< its code has failed
};

/// Something that the code of a component, or of an overlay, is to do.
struct OwnTask {
  enum class Kind {
    kActivate,   ///< its default action: it is due
    kCall,       ///< a service that answers at once
    kStart,      ///< one that answers later
    kInterrupt,  ///< its running service is to end as PREEMPTED
    kEnded,      ///< of an overlay: what it has started of its component has ended
  };
  sim::OwnComponent* component = nullptr;  ///< nullptr: it is the overlay's alone
  Kind kind = Kind::kActivate;
  std::string service = {};
  sim::Arguments arguments = {};  ///< valid during the call that the task is handed on by; of
                                  ///< kEnded: status and result
  std::int64_t ticket = 0;        ///< of kStart: by which its end is told; of kEnded: of the
                                  ///< callback, as the overlay has it
  Overlay* overlay = nullptr;     ///< whose task it is, where it is none of the component's
};

/// What came of a task. JSON in an object's members:
///   change    what is to be done (OwnChange)
///   result    of kCall
///   failed    text: the service's FAILED
///   wrong     text: likewise, an argument is of the wrong type
///   ended     list of [ticket, "SUCCESS" | "FAILED" | "PREEMPTED", result] of services that ended
///   error     text for the log; the component goes on
///   anew      true: its code was started anew, and what it was doing is lost
///   off       text for the log: the component must not be asked again
///   name      of an overlay that was made: what clients call it by
using OwnAnswer = Json;

/// Runs the code of the components of one language. Not thread safe.
class CodeHost {
 public:
  virtual ~CodeHost() = default;

  /// Takes each answer, in the order of the tasks.
  using Taker = std::function<void(const OwnTask&, const OwnAnswer&)>;

  /// Has tasks done one after the other. Never throws on what the code does: that is in the
  /// answers.
  virtual void Perform(std::span<const OwnTask> tasks, const Taker& taker) = 0;
};

}  // namespace ccmorse::servers
