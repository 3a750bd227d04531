"""A screen that nobody sees, with a mouse and a keyboard that nobody touches."""

import os
import shutil
import subprocess

PROGRAMS = ("Xvfb", "xdotool", "import", "rviz")


def missing_programs():
    """Return which of the needed programs are not installed."""
    return [program for program in PROGRAMS if shutil.which(program) is None]


class Screen:
    """Xvfb on a display of its own, ended by close()."""

    def __init__(self, width=1400, height=900):
        reader, writer = os.pipe()
        # Xvfb chooses a free display and says which once it is ready.
        self._server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{width}x{height}x24"],
            pass_fds=[writer],
            stderr=subprocess.DEVNULL,
        )
        os.close(writer)
        with os.fdopen(reader) as pipe:
            self.environment = {"DISPLAY": f":{pipe.readline().strip()}", "LIBGL_ALWAYS_SOFTWARE": "1"}

    def close(self):
        self._server.terminate()
        self._server.wait()

    def run(self, *command, timeout=120):
        """Run a program on this screen and return its output."""
        environment = {**os.environ, **self.environment}
        result = subprocess.run(
            command, env=environment, check=True, capture_output=True, text=True, timeout=timeout
        )
        return result.stdout

    def takes_keyboard(self, title):
        """Give a window the keyboard, for there is no window manager to do so; return whether it is there."""
        # When a window goes that it looks at, as a splash screen does, xdotool fails or waits for ever.
        try:
            windows = self.run("xdotool", "search", "--onlyvisible", "--name", title, timeout=10).split()
            self.run("xdotool", "windowfocus", "--sync", windows[-1], timeout=10)
        except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
            return False
        return True

    def press_key(self, key):
        self.run("xdotool", "key", key)

    def drag(self, start, end):
        """Drag with the left button from pixel to pixel, by way of the middle as a hand would."""
        middle = [(a + b) // 2 for a, b in zip(start, end)]
        steps = ["mousemove", *start, "mousedown", 1]
        for point in (middle, end):
            steps += ["sleep", 0.2, "mousemove", *point]
        self.run("xdotool", *map(str, [*steps, "sleep", 0.2, "mouseup", 1]))

    def save_picture(self, path):
        self.run("import", "-window", "root", str(path))
