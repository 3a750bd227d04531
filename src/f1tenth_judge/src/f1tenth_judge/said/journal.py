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
        """Begin the file: before there is a planner, who could put a pipe there."""
        self._file = file
        self._stream: Optional[TextIO] = None
        self._is_empty = True
        with contextlib.suppress(OSError):
            file.unlink(missing_ok=True)
            self._stream = file.open("x", encoding="utf-8", buffering=1)

    def note(self, topic: str, time: float, drawn: Sequence[Drawing]) -> None:
        """Write a line; one of the same time replaces the one before. A full disk ends it silently."""
        self._is_empty = False
        if self._stream is None:
            return
        line = {"time": time, "topic": topic, "drawn": drawn}
        try:
            self._stream.write(json.dumps(line, default=vars, separators=(",", ":")) + "\n")
        except OSError:
            self.close()

    def close(self) -> None:
        """Write no more; no file remains of nothing."""
        stream, self._stream = self._stream, None
        if stream:
            with contextlib.suppress(OSError):
                stream.close()
        if self._is_empty:
            with contextlib.suppress(OSError):
                self._file.unlink()
