"""Which tests look at a file that mutmut changes: those of its folder, in each package that has some.

Changes that are no fault, so that no test can see them:

- `<` for `<=` where stamps are compared within STAMP_EPSILON, or measured numbers: equal by chance only;
- another value where any would do: size, colour and distance in a picture, the interval between two looks,
  the grid of a search, the grace in which processes end, None for an empty value of which only the truth is
  asked;
- a default that every caller overrides, and what changes costs alone, as `buffering` and `daemon`;
- texts that only people who work at this project read: of assertions.
"""

_RACE_STATES = "f1tenth_scenarios/test/run/test_race_states.py"
_TESTS = {
    "f1tenth_judge/judge": ["f1tenth_judge/test/judge", _RACE_STATES],
    "f1tenth_judge/results": [
        "f1tenth_judge/test/results",
        "f1tenth_scenarios/test/results",
        "f1tenth_judge/test/cli",
        "f1tenth_judge/test/batch",
    ],
    "f1tenth_judge/record": ["f1tenth_judge/test/record", "f1tenth_judge/test/judge", _RACE_STATES],
    "f1tenth_judge/run": [
        "f1tenth_judge/test/run",
        "f1tenth_scenarios/test/run",
        "f1tenth_judge/test/drivers/python",
    ],
    "f1tenth_scenarios/run": ["f1tenth_scenarios/test/run", "f1tenth_scenarios/test/run/director.test"],
    "f1tenth_scenarios/launch": ["f1tenth_scenarios/test/launch"],
    "f1tenth_gazebo/driving": ["f1tenth_gazebo/test/driving"],
    "f1tenth_gazebo/goals": ["f1tenth_gazebo/test/goals"],
    "f1tenth_gazebo/maps": ["f1tenth_gazebo/test/maps"],
    "f1tenth_gazebo/roads": ["f1tenth_gazebo/test/roads"],
    "f1tenth_gazebo/worlds": ["f1tenth_gazebo/test/worlds"],
    "f1tenth_gazebo": ["f1tenth_gazebo/test/test_outputs.py", "f1tenth_gazebo/test/test_generated_files.py"],
    "f1tenth_race_mgr": ["f1tenth_race_mgr/test", "f1tenth_race_mgr/test/race_mgr.test"],
    "f1tenth_race_starter": ["f1tenth_race_starter/test", "f1tenth_race_starter/test/race_starter.test"],
}


def pre_mutation(context):
    """Called by mutmut before each change."""
    tests = next(tests for room, tests in _TESTS.items() if f"/src/{room}/" in context.filename)
    paths = " ".join(f"src/{each}" for each in tests if not each.endswith(".test"))
    commands = [f"/usr/bin/python3 -m pytest -x -q -o python_files=test_*.py {paths}"]
    commands += [f"rostest src/{each}" for each in tests if each.endswith(".test")]
    context.config.test_command = f"bash -c '{' && '.join(commands)}'"
