"""Names of the files in the folder of a run."""

RESULT_FILE, JUNIT_FILE = "result.json", "junit.xml"
TRAJECTORY_FILE, PICTURE_FILE = "trajectory.csv", "trajectory.png"
REPLAY_FILE, BAG_FILE = "replay.json.gz", "run.bag"
PREVIOUS_FOLDER = "previous"
