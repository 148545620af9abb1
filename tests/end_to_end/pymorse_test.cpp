// MORSE's own Python client, as Debian packages it, against our simulator.

#include <gtest/gtest.h>

#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

// Debian's python: pymorse is installed for it, and needs a module that newer ones lack.
constexpr const char* kPython = "/usr/bin/python3";

// pymorse's close() is broken on Python 3.8 and later unless it does not wait for publishers.
constexpr const char* kScript = R"(
import sys, pymorse
m = pymorse.Morse('127.0.0.1', int(sys.argv[1]))
assert m.robots == ['s1r'], m.robots
before = m.s1r.pose.get(timeout=10)
m.s1r.motion.publish({'v': 0.2, 'w': 0.0})
m.sleep(0.5)
after = m.s1r.pose.get(timeout=10)
assert abs(after['y'] - before['y']) > 0.05, (before, after)
assert len(m.s1r.hokuyo.get(timeout=10)['range_list']) == 682
assert m.s1r.waypoint.goto(after['x'], after['y'], 0.0, 0.5, 0.3).result() == 'Arrived'
try:
    m.rpc('s1r.motion', 'set_speed', 1)
    raise SystemExit('a wrong number of parameters was accepted')
except TypeError:
    pass
try:
    m.rpc('simulation', 'get_stream_port', 'nobody')
    raise SystemExit('a stream of nobody was found')
except pymorse.MorseServiceFailed:
    pass
future = m.s1r.waypoint.goto(5.0, 5.0, 0.0)
while m.rpc('s1r.waypoint', 'get_status') != 'Transit':
    pass  # a cancel that overtakes the request would find nothing to cancel
future.cancel()
try:
    future.result()
    raise SystemExit('a cancelled goto arrived')
except pymorse.MorseServicePreempted:
    pass
assert m.time() > 0
m.close(wait_publishers=False)
print('all well')
)";

TEST(Pymorse, DebiansOwnClientTalksToUsUnmodified) {
  const TemporaryFile script(".py", kScript);
  Simulator simulator({"syrotek"});
  const Finished python = RunToEnd({kPython, script.path(), std::to_string(simulator.port())});
  EXPECT_EQ(python.status, 0) << python.output;
  EXPECT_NE(python.output.find("all well"), std::string::npos) << python.output;
}

}  // namespace
}  // namespace ccmorse::testing
