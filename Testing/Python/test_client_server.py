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
        log.seek(0)
        log.truncate()
        server = subprocess.Popen(
            ["timeout", str(SECONDS), sys.argv[1], f"--server-port={port}"],
            stdout=log, stderr=subprocess.STDOUT)
        while server.poll() is None:
            log.seek(0)
            if "Accepting connection" in log.read():
                return server, port
            time.sleep(0.1)
    raise RuntimeError("no server could be started")


with tempfile.TemporaryFile("w+") as log:
    server, port = start_server(log)
    try:
        subprocess.run(["timeout", str(SECONDS), sys.argv[2], str(CLIENT), str(port)], check=True)
        assert server.wait(10) == 0, server.returncode
    finally:
        if server.poll() is None:
            server.terminate()  # which timeout hands on
            server.wait(10)
        log.seek(0)
        print(log.read())
