"""Descriptions of cars that are written in xacro."""

from xml.dom import minidom


def expanded(path) -> str:
    """Return the XML of a file with its macros expanded."""
    import xacro

    _write_attributes_unless_told()
    return xacro.process_file(str(path)).toxml()


def _write_attributes_unless_told():
    # Python 3.13 wants to be told what is written; xacro 1.13.3 writes attributes, and does not say so.
    write_data = minidom._write_data  # type: ignore[attr-defined]
    if write_data.__code__.co_argcount == 3:
        write_data.__defaults__ = (True,)
