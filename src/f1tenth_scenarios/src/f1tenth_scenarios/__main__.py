"""python3 -m f1tenth_scenarios: the command `scenario`."""

from f1tenth_scenarios.cli import main
from f1tenth_scenarios.cli.exit_codes import leave

if __name__ == "__main__":
    leave(main())
