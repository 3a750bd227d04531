"""What planners draw, written down at once for those who watch the run."""

import contextlib
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Optional, TextIO

from f1tenth_judge.record.replay import Drawing


class Journal:
    """A line for each drawing: its time (s), its topic, and what is shown from then on."""

    def __init__(self, file: Path):
        """Write nothing yet."""
        self._file = file
        self._stream: Optional[TextIO] = None
        self._is_broken = False

    def note(self, topic: str, time: float, drawn: Sequence[Drawing]) -> None:
        """Write a line; one of the same time replaces the one before. A full disk ends it silently."""
        if self._is_broken:
            return
        try:
            if self._stream is None:
                self._stream = self._file.open("w", encoding="utf-8", buffering=1)
            line = {"time": time, "topic": topic, "drawn": drawn}
            self._stream.write(json.dumps(line, default=vars, separators=(",", ":")) + "\n")
        except OSError:
            self._is_broken = True

    def close(self) -> None:
        """Write no more."""
        if self._stream:
            with contextlib.suppress(OSError):
                self._stream.close()
