"""Compare a factor in a query engine with the bare multiplication; see README.md."""

import sys
import tempfile
from pathlib import Path

import numpy
import polars
from measure import report

import radcalc

ROWS = 20_000_000
RUNS = 5


def main() -> bool:
    """Stream a Parquet file through Polars, with radcalc's factor and with a constant."""
    with tempfile.TemporaryDirectory() as folder:
        log, found = Path(folder, "log.parquet"), Path(folder, "ppfd.parquet")
        lux = numpy.random.default_rng(1).uniform(0, 1e5, ROWS)
        polars.DataFrame({"lux": lux}).write_parquet(log)
        del lux

        def multiply(factor: float) -> None:
            ppfd = polars.col("lux") * factor
            polars.scan_parquet(log).with_columns(ppfd=ppfd).sink_parquet(found)

        def ours() -> None:
            multiply(radcalc.factor("lx", "umol/m2/s", spectrum="LED-B3"))

        name = f"{ROWS:.0e} rows of Parquet through Polars against the bare multiplication"
        return report(name, ours, lambda: multiply(0.014), 1.2, RUNS)


if __name__ == "__main__":
    sys.exit(not main())
