#pragma once

namespace ccmorse::tools {

/// `ccmorse bench all`: the figures of docs/performance.md as one table: what is required, what is
/// aimed at, what this machine does. Runs the other benchmarks as processes of their own, one after
/// the other; under 3 minutes. Returns the exit status: 0 when it could measure, met or not.
int BenchAll(bool json);

}  // namespace ccmorse::tools
