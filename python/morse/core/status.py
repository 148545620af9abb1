"""How a service ended."""

SUCCESS = "SUCCESS"
FAILED = "FAILED"
PREEMPTED = "PREEMPTED"
