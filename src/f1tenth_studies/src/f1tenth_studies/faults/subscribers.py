"""Hundreds of subscribers that read what they get, or never do; a separate program.

They speak TCPROS themselves, because a node has only one connection per topic.
"""

import selectors
import socket
import struct
import sys
import time
import xmlrpc.client
from typing import Any

import rosgraph

_CALLER = "/subscribers"
_PATIENCE = 20.0  # wall s, for the topic to appear


def main(topic: str, count: int, reads: bool) -> None:
    """Subscribe `count` times to a topic and read until the publisher ends, or never read."""
    host, port = _address(topic)
    connections = [_connect(topic, host, port, number) for number in range(count)]
    print("connected", flush=True)
    if not reads:
        time.sleep(3600.0)
    with selectors.DefaultSelector() as selector:
        for each in connections:
            selector.register(each, selectors.EVENT_READ, each)
        while selector.get_map():
            for key, _ in selector.select():
                if not key.data.recv(1 << 16):
                    selector.unregister(key.data)


def _address(topic: str) -> tuple[str, int]:
    master = rosgraph.Master(_CALLER)
    deadline = time.monotonic() + _PATIENCE
    while not (nodes := dict(master.getSystemState()[0]).get(topic)):
        if time.monotonic() > deadline:
            sys.exit(f"subscribers: nobody publishes {topic}")
        time.sleep(0.05)
    publisher: Any = xmlrpc.client.ServerProxy(master.lookupNode(nodes[0]))
    _, _, (_, host, port) = publisher.requestTopic(_CALLER, topic, [["TCPROS"]])
    return host, port


def _connect(topic: str, host: str, port: int, number: int) -> socket.socket:
    fields = [f"callerid=/subscriber_{number}", f"topic={topic}", "md5sum=*", "type=*", "tcp_nodelay=1"]
    header = b"".join(struct.pack("<I", len(each)) + each.encode() for each in fields)
    connection = socket.create_connection((host, port))
    connection.sendall(struct.pack("<I", len(header)) + header)
    return connection


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), sys.argv[3] == "reading")
