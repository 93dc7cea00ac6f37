# SPDX-License-Identifier: BSD-3-Clause
"""Links and pictures of the installed pages are there.

usage: python3 check_links.py FOLDER
"""

import pathlib
import re
import sys

folder = pathlib.Path(sys.argv[1])
pages = sorted([*folder.rglob("*.md"), *folder.rglob("*.html")])
assert {page.suffix for page in pages} == {".md", ".html"}, pages
missing = []
for page in pages:
    pattern = r"\]\(([^)#\s]+)[^)]*\)" if page.suffix == ".md" else r"""(?:href|src)="([^"#]+)["#]"""
    for link in set(re.findall(pattern, page.read_text(encoding="utf-8"))):
        if not re.match(r"https?:|javascript:|\$", link) and not (page.parent / link).exists():
            missing.append(f"{page.relative_to(folder)}: {link}")
assert not missing, "\n".join(missing)
print(f"The links of {len(pages)} pages lead somewhere.")
