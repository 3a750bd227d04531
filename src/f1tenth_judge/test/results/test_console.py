"""What is said of many runs while they are in progress."""

import io

from f1tenth_judge.results.console import CountLine


class Terminal(io.StringIO):
    def isatty(self):
        return True


def said(count, stream, **options):
    line = CountLine("roads", count, stream, **options)
    for number in range(count):
        line.update(number % 2 == 0)
    return stream.getvalue()


def test_a_log_has_a_line_for_each_tenth_of_the_runs():
    lines = said(40, io.StringIO()).splitlines()
    assert lines[:2] == ["roads  4 of 40, 2 passed", "roads  8 of 40, 4 passed"]
    assert lines[-1] == "roads  40 of 40, 20 passed"
    assert len(lines) == 10
    assert said(3, io.StringIO()).splitlines() == [
        f"roads  {n} of 3, {(n + 1) // 2} passed" for n in (1, 2, 3)
    ]
    assert said(40, io.StringIO(), each_is_told=True) == ""


def test_a_terminal_has_one_line_that_is_drawn_over():
    text = said(40, Terminal())
    assert "\n" not in text
    assert text.endswith(f"\rroads  {30 * '█'}  40 of 40, 20 passed".replace("\r", "\r\033[K"))
