"""Names of the commands and of options that need no command."""

from radcalc.calculators.pages import SUMMARIES

# In the order of the help.
COMMANDS = {
    **SUMMARIES,
    "mark": "Marks and points for the answers of students to a sheet.",
    "columns": "Columns of a table: units, extremes, means.",
    "units": "Units, their definitions and sources.",
    "quantities": "Names of quantities in three languages.",
    "typical": "Typical values: sun, sky, rooms, lamps, screens.",
    "examples": "Tasks with their commands, answers and how to read them.",
    "help": "Help for a command, or a search for words.",
    "prompt": "Interactive prompt, with ans and variables.",
}
HELP_NAMES = ["-h", "--help"]
EXPLAIN = "--explain"
