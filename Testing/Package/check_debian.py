# SPDX-License-Identifier: BSD-3-Clause
"""Debian's packages have what is theirs where Debian wants it. The plugin is in the folder that ParaView has for
plugins of other packages, else its package shares ParaView's list of plugins with whoever has lines in it.

usage: python3 check_debian.py FOLDER MULTIARCH
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

folder, multiarch = pathlib.Path(sys.argv[1]), sys.argv[2]
packages = {path.name.split("_")[0]: path for path in folder.glob("*.deb")}
files = {name: subprocess.run(["dpkg-deb", "--contents", path], check=True, text=True,
                              stdout=subprocess.PIPE).stdout for name, path in packages.items()}


def field(name, key):
    return subprocess.run(["dpkg-deb", "--field", packages[name], key], check=True, text=True,
                          stdout=subprocess.PIPE).stdout.strip()


for name, listing in files.items():
    paths = re.findall(r" \./(\S*[^/\s])(?: -> .*)?\n", listing)
    assert paths, listing
    of_compiler = [path for path in paths if re.search(r"\.so(\.|$)|/cmake/|\.plugins\.xml$", path)]
    # A link to the plugin may lie where ParaView looks for plugins of other packages, see below.
    strange = [path for path in of_compiler
               if not path.startswith((f"usr/lib/{multiarch}/", "usr/lib/python3/"))
               and f" ./{path} -> ../../../lib/{multiarch}/" not in listing]
    assert not strange, strange
    assert not [path for path in paths if path.startswith("usr/bin/")], paths
    assert re.fullmatch(r"[^<>]+ <[^@<>]+@[^@<>]+>", field(name, "Maintainer")), field(name, "Maintainer")
    assert ".invalid" not in field(name, "Maintainer")
if "geodesic-distance-doc" in packages:
    assert "/html/classvtkGeodesicDistanceField.html" in files["geodesic-distance-doc"]

# ------------------------------------------------------------------------------- the list of plugins
def check_shared_list(scripts, root):
    plugins = root / "usr/bin/paraview.conf"
    plugins.parent.mkdir(parents=True)

    def run(script, what):
        subprocess.run([scripts / script, what], check=True, env={**os.environ, "DPKG_ROOT": str(root)})

    run("postinst", "configure")
    ours = plugins.read_text()
    assert ours.count("\n") == 1 and ours.endswith("/geodesicdistance.plugins.xml\n"), ours
    run("postinst", "configure")
    assert plugins.read_text() == ours, plugins.read_text()
    run("postrm", "upgrade")
    assert plugins.read_text() == ours, plugins.read_text()
    run("postrm", "remove")
    run("postrm", "purge")
    assert not plugins.exists()

    plugins.write_text("of/another/package.xml\n/opt/of the/administrator.xml")  # without a line's end
    run("postinst", "configure")
    assert plugins.read_text() == "of/another/package.xml\n/opt/of the/administrator.xml\n" + ours
    run("postrm", "remove")
    assert plugins.read_text() == "of/another/package.xml\n/opt/of the/administrator.xml\n"


with tempfile.TemporaryDirectory() as scratch:
    control, root = pathlib.Path(scratch, "control"), pathlib.Path(scratch, "root")
    subprocess.run(["dpkg-deb", "--control", packages["geodesic-distance"], control], check=True)
    offered = re.search(r" \./usr/share/paraview/plugins/GeodesicDistance\.so -> (\S+)\n", files["geodesic-distance"])
    if offered:
        plugin = os.path.normpath(f"usr/share/paraview/plugins/{offered.group(1)}")
        assert f" ./{plugin}\n" in files["geodesic-distance"], plugin
        assert not {"postinst", "postrm"} & set(os.listdir(control)), os.listdir(control)
    else:
        check_shared_list(control, root)
print(f"{', '.join(sorted(packages))}: folders, fields and the list of plugins are right.")
