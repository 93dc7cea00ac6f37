# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: the plugin on a pvserver of two ranks. Arguments: mpirun and pvserver."""

import os
import socket
import subprocess
import sys

from paraview import servermanager, simple

MPIRUN, PVSERVER = sys.argv[1:3]


def free_port():
    with socket.socket() as listener:
        listener.bind(("localhost", 0))
        return listener.getsockname()[1]


def distance_range(field):
    field.UpdatePipeline()
    return field.PointData.GetArray("GeodesicDistance").GetRange()


def start(port):
    """A pvserver of two ranks that waits for its client."""
    # pvpython may have started MPI, which mpirun must not take for its own.
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    server = subprocess.Popen(
        [MPIRUN, "--allow-run-as-root", "--oversubscribe", "-np", "2", PVSERVER,
         f"--server-port={port}", "--force-offscreen-rendering"],
        stdout=subprocess.PIPE, env=environment, text=True)
    for line in server.stdout:
        if "Accepting connection" in line:
            break
    return server


def main():
    port = free_port()
    with start(port) as server:
        try:
            if not simple.Connect("localhost", port):
                return "pvserver does not answer"
            simple.LoadPlugin(os.environ["GEODESIC_PLUGIN"], remote=True)
            simple.LoadPlugin(os.environ["GEODESIC_PLUGIN"], remote=False, ns=vars(simple))
            ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
            if ranks != 2:
                return f"pvserver has {ranks} ranks"
            sphere = simple.Sphere(ThetaResolution=40, PhiResolution=30)
            pole = simple.PointSource(NumberOfPoints=1, Radius=0, Center=(0, 0, 0.5))
            field = simple.GeodesicDistanceField(Input=sphere, Source=pole)
            low, high = distance_range(field)
            if low != 0.0 or not 1.5 < high < 1.5708:
                return f"from pole to pole it is not {high}"
            numbers = field.FieldData.GetArray("SeamPointsJoined")
            if not numbers or numbers.GetRange()[0] <= 0:
                return "the seams of the two ranks' pieces are not joined"
            # All on one rank, and a change that executes again.
            line = simple.Line(Point1=(-0.4, 0, 0.3), Point2=(0.4, 0, 0.3))
            field.Source = line
            if not 0.5 < distance_range(field)[1] < 1.5:
                return "with another source the distance is wrong"
            return ""
        finally:
            simple.Disconnect()  # after which a server of two ranks may wait for ever
            server.terminate()


problem = main()
if problem:
    sys.exit(problem)
print("a pvserver of two ranks has the field of the whole")
