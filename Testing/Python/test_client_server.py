# SPDX-License-Identifier: BSD-3-Clause
"""A client with a server on one rank, as the README has it: the plugin, which neither finds by
itself, is loaded on both sides; the four filters give the right values.

usage: python3 test_client_server.py PVSERVER PVPYTHON
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time

SECONDS = 50  # for each of the two
CLIENT = pathlib.Path(__file__).resolve().with_name("client_of_server.py")


def start_server(log):
    """A server, which ends with its client or in time, and its port, one that was free."""
    for port in range(20000 + os.getpid() % 20000, 60000, 37):
        with open(log, "w") as written:
            server = subprocess.Popen(
                ["timeout", str(SECONDS), sys.argv[1], f"--server-port={port}"],
                stdout=written, stderr=subprocess.STDOUT)
        while server.poll() is None:
            if "Accepting connection" in log.read_text():
                return server, port
            time.sleep(0.1)
    raise RuntimeError("no server could be started: " + log.read_text())


with tempfile.TemporaryDirectory() as folder:
    log = pathlib.Path(folder) / "server.log"
    server, port = start_server(log)
    try:
        subprocess.run(["timeout", str(SECONDS), sys.argv[2], str(CLIENT), str(port)], check=True)
        assert server.wait(10) == 0, server.returncode
    finally:
        if server.poll() is None:
            server.terminate()  # which timeout hands on
            server.wait(10)
        print(log.read_text())
