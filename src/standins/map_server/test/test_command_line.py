import pytest
from map_server import map_saver_node, map_server_node


def test_saver_s_defaults_are_the_original_s():
    options = map_saver_node.parse_arguments([])
    assert (options.name, options.occ, options.free) == ("map", 65, 25)


def test_saver_takes_name_and_thresholds():
    options = map_saver_node.parse_arguments(["-f", "circuit1", "--occ", "100", "--free", "0"])
    assert (options.name, options.occ, options.free) == ("circuit1", 100, 0)


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["--occ", "0"], "argument --occ: found '0', allowed is a whole number from 1 to 100"),
        (["--occ", "101"], "argument --occ: found '101', allowed is a whole number from 1 to 100"),
        (["--occ", "half"], "argument --occ: found 'half', allowed is a whole number from 1 to 100"),
        (["--free", "101"], "argument --free: found '101', allowed is a whole number from 0 to 100"),
        (["--free", "-1"], "argument --free: found '-1', allowed is a whole number from 0 to 100"),
        (["--occ", "25"], "--occ 25 must exceed --free 25"),
        (["-f"], "argument -f: expected one argument"),
        (["circuit1"], "unrecognized arguments: circuit1"),
    ],
)
def test_saver_answers_wrong_arguments_with_usage_and_exit_1(capsys, arguments, reason):
    with pytest.raises(SystemExit) as raised:
        map_saver_node.parse_arguments(arguments)
    assert raised.value.code == 1
    output = capsys.readouterr().err
    assert output.startswith("usage: map_saver ")
    assert output.endswith(f"map_saver: error: {reason}\n")


def test_saver_explains_itself_on_request(capsys):
    with pytest.raises(SystemExit) as raised:
        map_saver_node.parse_arguments(["-h"])
    assert raised.value.code == 0
    assert "-f NAME" in capsys.readouterr().out


@pytest.mark.parametrize("arguments", [[], ["a.yaml", "0.1", "more"]])
def test_server_answers_wrong_arguments_with_usage_and_exit_255(capsys, arguments):
    assert map_server_node.main(["map_server", *arguments, "map:=other"]) == 255
    assert capsys.readouterr().err == map_server_node.USAGE + "\n"
