"""Asking ROS nodes and the master by their XML-RPC interfaces, with a limit to the wait for an answer."""

import http.client
import xmlrpc.client
from typing import Any


def ros_api(uri: str, patience: float) -> Any:
    """The interface of a node or of the master (http://wiki.ros.org/ROS/Slave_API, Master_API).

    Its methods raise TimeoutError after `patience` (wall s): the one that is asked may be stopped.
    """
    return xmlrpc.client.ServerProxy(uri, transport=_Impatient(patience))


class _Impatient(xmlrpc.client.Transport):
    def __init__(self, patience: float):
        super().__init__()
        self._patience = patience

    def make_connection(self, host: Any) -> http.client.HTTPConnection:
        connection = super().make_connection(host)
        connection.timeout = self._patience
        return connection
