"""python3 -m f1tenth_scenarios: the command `scenario`."""

import sys

from f1tenth_scenarios.cli import main

if __name__ == "__main__":
    sys.exit(main())
