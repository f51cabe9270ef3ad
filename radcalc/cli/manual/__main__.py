"""Rewrite the generated parts of the manual: `python -m radcalc.cli.manual man`."""

import sys
from pathlib import Path

from radcalc.cli.manual import rewritten

page_paths = sorted(Path(sys.argv[1]).glob("man?/radcalc*.?"))
if not page_paths:
    sys.exit(f"there are no pages in {sys.argv[1]}/man1")
for page in page_paths:
    page.write_text(rewritten(page.read_text(encoding="utf-8")), encoding="utf-8")
