"""Descriptions of cars that are written in xacro."""

import io
from xml.dom import Node
from xml.sax.saxutils import XMLGenerator


def expanded(path) -> str:
    """Return the XML of a file with its macros expanded."""
    import xacro

    text = io.StringIO()
    _write(xacro.process_file(str(path)).documentElement, XMLGenerator(text, short_empty_elements=True))
    return text.getvalue()


def _write(element, output) -> None:
    # Not by minidom, of which xacro 1.13.3 replaces a part by one that Python 3.13 cannot use.
    output.startElement(element.tagName, dict(element.attributes.items()))
    for each in element.childNodes:
        if each.nodeType == Node.ELEMENT_NODE:
            _write(each, output)
        elif each.nodeType in (Node.TEXT_NODE, Node.CDATA_SECTION_NODE):
            output.characters(each.data)
    output.endElement(element.tagName)
