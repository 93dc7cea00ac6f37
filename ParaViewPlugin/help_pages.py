# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pages that ParaView's "?" button opens, one a filter, from the descriptions of the filters in XML.

ParaView's own way needs xmlpatterns, which ends with Qt 5, and knows no pictures.

usage: python3 help_pages.py QHELPGENERATOR GALLERY OUTPUT.qch XML...
"""

import html
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

NAME = "GeodesicDistance"  # ParaView looks for pages in the folder NAME of the namespace NAME.org
PICTURES = {
    "GeodesicContour": "offset_curves", "GeodesicDistanceField": "stripes",
    "GeodesicDistanceFieldFromDrawnCurve": "drawn_curve", "GeodesicDistanceMatrix": "distance_matrix",
    "GeodesicPaths": "shortest_paths"}
STYLE = "body { font-family: sans-serif } td { padding: 4px 12px 4px 0; vertical-align: top }"


def formatted(text):
    """A description with its *names* as HTML, in paragraphs."""
    text = html.escape(text or "", quote=False)
    text = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", text, flags=re.DOTALL)
    text = re.sub(r"\*(.+?)\*", r"<i>\1</i>", text, flags=re.DOTALL)
    return "".join(f"<p>{' '.join(paragraph.split())}</p>" for paragraph in re.split(r"\n\s*\n", text))


def read(files):
    """All filters by their names, those without a label being the base of others."""
    found = (ElementTree.parse(file).getroot().iter("SourceProxy") for file in files)
    return {proxy.get("name"): proxy for proxies in found for proxy in proxies}


def properties(proxy, filters):
    """Properties by their names, a filter's own in the place of those of its base."""
    base = filters.get(proxy.get("base_proxyname"))
    result = properties(base, filters) if base is not None else {}
    for child in proxy:
        if child.tag.endswith("Property"):
            result[child.get("name")] = child
    return result


def is_shown(prop):
    label = prop.get("label", prop.get("name")).strip()
    return bool(label) and prop.get("is_internal") != "1" and prop.get("panel_visibility") != "never"


def default(prop):
    value = prop.get("default_values", "")
    texts = {entry.get("value"): entry.get("text") for entry in prop.iter("Entry")}
    if prop.find("BooleanDomain") is not None:
        texts = {"0": "off", "1": "on"}
    return html.escape(texts.get(value, value)) if prop.get("information_only") != "1" else ""


def page(proxy, filters):
    label, name = proxy.get("label"), proxy.get("name")
    rows = "".join(
        f"<tr><td><b>{html.escape(prop.get('label', prop.get('name')))}</b></td><td>{default(prop)}</td>"
        f"<td>{formatted(prop.findtext('Documentation'))}</td></tr>\n"
        for prop in properties(proxy, filters).values() if is_shown(prop))
    return f"""<html><head><title>{label}</title><style>{STYLE}</style></head><body>
<h1>{label}</h1>
<img src="{PICTURES[name]}.png" width="560">
{formatted(proxy.findtext("Documentation"))}
<h2>Properties</h2>
<table><tr><td><b>Property</b></td><td><b>Default</b></td><td><b>Description</b></td></tr>
{rows}</table>
</body></html>
"""


def project(filters):
    files = [f"filters.{name}.html" for name in filters] + [f"{PICTURES[name]}.png" for name in filters]
    sections = "".join(f'<section title="{proxy.get("label")}" ref="filters.{name}.html"/>'
                       for name, proxy in filters.items())
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<QtHelpProject version="1.0"><namespace>{NAME}.org</namespace><virtualFolder>{NAME}</virtualFolder>
<filterSection><toc><section title="Geodesic Distance" ref="filters.GeodesicDistanceField.html">{sections}</section></toc>
<files>{"".join(f"<file>{file}</file>" for file in files)}</files></filterSection></QtHelpProject>
"""


def main(generator, gallery, output, files):
    folder = pathlib.Path(output).resolve().parent
    folder.mkdir(parents=True, exist_ok=True)
    known = read(files)
    filters = {name: proxy for name, proxy in known.items() if proxy.get("label")}
    for name, proxy in filters.items():
        (folder / f"filters.{name}.html").write_text(page(proxy, known), encoding="utf-8")
        shutil.copy(pathlib.Path(gallery) / f"{PICTURES[name]}.png", folder)
    (folder / f"{NAME}.qhp").write_text(project(filters), encoding="utf-8")
    subprocess.run([generator, folder / f"{NAME}.qhp", "-s", "-o", output], check=True)


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    main(*sys.argv[1:4], sys.argv[4:])
