"""The shell's spelling of the symbols and commands that messages mention."""

from radcalc.errors import spell

NEED_QUOTES = set(" ()<>;&|")  # at a shell


class Shell:
    """Options begin with two dashes, and a command is what one types."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """`--height 6m`."""
        text = f"'{value}'" if "'" not in value and NEED_QUOTES.intersection(value) else value
        return f"{'-g' if name == 'get' else f'--{name}'} {text}".rstrip()

    @staticmethod
    def command(*words: str) -> str:
        """`radcalc solid-angle cone --half-angle 30deg`; a word with = is an option."""
        typed = []
        for word in words:
            name, equals, value = word.partition("=")
            text = value if equals else word
            quoted = f"'{text}'" if NEED_QUOTES.intersection(text) else text
            typed.append(Shell.option(name, text) if equals else quoted)
        return " ".join(["radcalc", *typed])

    @staticmethod
    def manual(name: str) -> str:
        """Return the call that describes the command."""
        return f"radcalc {name} --help"

    @staticmethod
    def measured(unit: str) -> str:
        """`illuminance (lx)`."""
        from radcalc.quantities.light import describe
        from radcalc.units.table import resolve

        return describe(resolve(unit))


def spelled(text: str) -> str:
    """A text with what it mentions, as one types it at a shell."""
    return spell(text, Shell)
