"""Completion of the next word, for the shells and for a prompt in the same process.

A shell (bash, zsh or fish) has a script, the line that it sends, and the words that it gets.

`radcalc.completion.rows` prints the `table` of commands and options for a wheel, so that
completion does not load Click, which is too slow.
"""

import os

from radcalc import terminal
from radcalc.completion.table import COMMANDS, RADCALC
from radcalc.completion.words import HELP, Completion, Line, Option, files, is_option
from radcalc.errors import RadcalcError, UsageError, quote
from radcalc.units.numbers import is_sentence

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence


def completions(words: "Sequence[str]", incomplete: str) -> list[Completion]:
    """Return every completion of the word `incomplete` after `words`, the best first.

    The words are without `radcalc` itself and without the quotes of a shell.
    """
    try:
        candidates = _candidates(list(words), incomplete)
    except Exception:  # a Tab never reports an error
        if os.environ.get("RADCALC_DEBUG") == "1":
            raise
        return []
    once: dict[str, Completion] = {}
    for candidate in candidates:
        if candidate.text.startswith(incomplete):
            once.setdefault(candidate.text, candidate)
    return list(once.values())


def _candidates(words: list[str], incomplete: str) -> list[Completion]:
    if not words:
        return _first(incomplete)
    if words == [HELP] and (commands := _commands(incomplete)):
        return commands
    if words[0] in COMMANDS:
        return _in_command(Line(words[0], words[1:]), incomplete)
    if is_sentence(words):
        return _in_command(Line("convert", words), incomplete)
    return []


def _first(incomplete: str) -> list[Completion]:
    if incomplete == "-" or is_option(incomplete):
        return _options(map(Option, RADCALC), incomplete)
    if is_sentence([incomplete]):
        return _in_command(Line("convert", ()), incomplete)
    return _commands(incomplete)


def _commands(incomplete: str) -> list[Completion]:
    return [
        Completion(name, row[0]) for name, row in COMMANDS.items() if name.startswith(incomplete)
    ]


def _in_command(line: Line, incomplete: str) -> list[Completion]:
    """Return completions of a word after a command: values, options or operands."""
    if line.waiting:
        return _values(line.waiting, incomplete)
    if not line.is_closed:
        name, equals, text = incomplete.partition("=")
        if equals and (option := line.option(name)):
            return [value.after(name + equals) for value in _values(option, text)]
        if incomplete == "-" or is_option(incomplete):
            return _fitting_options(line, incomplete)
    form, values = line.operand
    candidates = []
    if form == "conversion":
        from radcalc.completion.targets import operands

        candidates = operands(line.operands, line.given, incomplete)
    elif not line.operands or (form == "spectrum" and incomplete):  # several spectra are compared
        from radcalc.completion.words import values_of

        candidates = values_of(form, values, incomplete)
    if line.offering:
        candidates = [*_values(line.offering, incomplete), *candidates]
    if not candidates and not incomplete:
        return _fitting_options(line, "" if not line.is_closed else "?")
    return candidates


def _values(option: Option, incomplete: str) -> list[Completion]:
    from radcalc.completion.words import values_of

    return values_of(option.form, option.values, incomplete)


def _fitting_options(line: Line, incomplete: str) -> list[Completion]:
    """Return the options not given yet, first those that the conversion lacks."""
    fitting = [
        option for option in line.options if option.repeats or option.names[-1] not in line.given
    ]
    if line.command == "convert" and line.operands and incomplete in ("", "-", "--"):
        from radcalc.completion.targets import lacking

        wanted = lacking(line.operands, line.given)
        first = [option for option in fitting if option.names[-1].lstrip("-") in wanted]
        if first and not incomplete:
            return _options(first, incomplete)
        fitting = [*first, *fitting]
    return _options(fitting, incomplete)


def _options(options: "Iterable[Option]", incomplete: str) -> list[Completion]:
    """Return options by name; hidden ones, which are other names, only if no other fits."""
    by_hidden: dict[bool, list[Completion]] = {False: [], True: []}
    for option in options:
        fitting = [name for name in option.names if name.startswith(incomplete)]
        if fitting:
            by_hidden[option.hidden].append(Completion(fitting[-1], option.help))
    return by_hidden[False] or by_hidden[True]


VARIABLE = "_RADCALC_COMPLETE"
LINE, BREAKS = "COMP_LINE", "COMP_WORDBREAKS"
SAFE = "_-./:=@%+,~^"  # characters that mean themselves in bash, like letters and digits
# A completion that ends its word includes the blank after it, which every bash can do.
BASH = """\
_radcalc_completion() {
    local line
    COMPREPLY=()
    while IFS= read -r line; do
        COMPREPLY+=("$line")
    done < <(_RADCALC_COMPLETE=bash_complete COMP_LINE="${COMP_LINE:0:COMP_POINT}" \\
        COMP_WORDBREAKS="$COMP_WORDBREAKS" "${1/#\\~\\//$HOME/}" 2>/dev/null)
}
complete -o nospace -o nosort -F _radcalc_completion radcalc 2>/dev/null ||
    complete -o nospace -F _radcalc_completion radcalc
"""
ZSH = """\
#compdef radcalc
_radcalc_completion() {
    local -a closed shown open shown_open
    local line
    for line in "${(@f)$(_RADCALC_COMPLETE=zsh_complete \\
        COMP_LINE="${(j: :)words[1,CURRENT-1]} $QIPREFIX$PREFIX" ${~words[1]} 2>/dev/null)}"; do
        case $line in
            (' '*) closed+=("${${line# }%%$'\t'*}") shown+=("${line#*$'\t'}") ;;
            (?*) open+=("${line%%$'\t'*}") shown_open+=("${line#*$'\t'}") ;;
        esac
    done
    compadd -V radcalc -ld shown -a closed
    compadd -V radcalc -S '' -ld shown_open -a open
}
if [[ $zsh_eval_context[-1] == loadautofunc ]]; then
    _radcalc_completion "$@"
else
    compdef _radcalc_completion radcalc
fi
"""
FISH = """\
function __radcalc_complete
    set -l program (string replace -r '^~/' $HOME/ -- (commandline -opc)[1])
    env _RADCALC_COMPLETE=fish_complete COMP_LINE=(commandline -pc | string collect) \\
        $program 2>/dev/null
end
complete --command radcalc --no-files --keep-order --arguments '(__radcalc_complete)'
"""
SCRIPTS = {"bash": BASH, "zsh": ZSH, "fish": FISH}


def answer_shell(request: str) -> int:
    """Write the answer to a shell, and return the exit status."""
    shell, _, wanted = request.partition("_")
    if shell in SCRIPTS and wanted == "source":
        return _write(SCRIPTS[shell].encode())
    if shell in SCRIPTS and wanted == "complete" and LINE in os.environ:
        lines = WRITERS[shell](Typed(os.environ[LINE], os.environ.get(BREAKS, "")))
        return _write("".join([f"{line}\n" for line in lines]).encode("utf-8", "surrogateescape"))
    problem = f"{VARIABLE}={quote(request)} is not a known request for completion"
    hint = "bash_source, zsh_source or fish_source there, or without it"
    return terminal.complain(UsageError(problem, hint))


def _write(data: bytes) -> int:
    try:
        terminal.pour(data)
    except BrokenPipeError:
        return terminal.ANSWERED
    except RadcalcError as error:
        return terminal.complain(error)
    return terminal.ANSWERED


class Typed:
    """A line up to the cursor: its words, and the word being typed.

    `quote` is an open quotation mark; `cut` is the start of the part of the last word that readline
    replaces: after one of its `breaks`, or an open quotation mark.
    """

    def __init__(self, line: str, breaks: str) -> None:
        self.words: list[str] = []
        self.word, self.quote, self.cut = "", "", 0
        self.is_redirected = False  # the word is a file after < or >
        is_word = False
        letters = iter(line)
        for letter in letters:
            if self.quote:
                if letter == self.quote:
                    self.quote = ""
                    self.cut = len(self.word) if letter in breaks else self.cut
                elif letter == "\\" and self.quote == '"':
                    after = next(letters, "")
                    self.word += after if after in '"\\$`' else letter + after
                else:
                    self.word += letter
            elif letter.isspace() or letter in "<>":
                if is_word and not (letter in "<>" and self.word.isdigit()):
                    self._end()
                is_word, self.word, self.cut = False, "", 0
                self.is_redirected = self.is_redirected or letter in "<>"
            else:
                is_word = True
                if letter in "'\"":
                    self.quote, self.cut = letter, len(self.word)
                else:
                    self.word += next(letters, "") if letter == "\\" else letter
                    self.cut = len(self.word) if letter in breaks else self.cut
        while self.words and "=" in self.words[0]:  # VARIABLE=VALUE radcalc
            del self.words[0]

    def _end(self) -> None:
        if not self.is_redirected:
            self.words.append(self.word)
        self.is_redirected = False

    def completions(self) -> list[Completion]:
        """Return completions of the last word, except files whose names have several lines."""
        if self.is_redirected:
            candidates = files(("",), self.word)
        else:
            _load_definitions(self.words)
            candidates = completions(self.words[1:], self.word)
        return [
            candidate for candidate in candidates if not {"\n", "\r", "\t"} & set(candidate.text)
        ]


def _load_definitions(words: "Sequence[str]") -> None:
    """Load the user's definitions; a Tab never reports their errors."""
    given = Line("convert", words).given.get("--definitions")
    if path := terminal.definitions_file(given):
        from radcalc.inputs import definitions

        try:
            definitions.load(path)
        except RadcalcError:
            return


def _bash(typed: Typed) -> list[str]:
    lines = []
    for candidate in typed.completions():
        text = candidate.text[typed.cut :]
        if typed.quote:
            lines.append(text if typed.quote == "'" else _escaped(text, lambda c: c not in '"\\$`'))
        else:
            text = _escaped(text, lambda c: c.isalnum() or c in SAFE or not c.isascii())
            lines.append(text + " " if candidate.closes else text)
    return lines


def _escaped(text: str, is_plain: "Callable[[str], bool]") -> str:
    return "".join([letter if is_plain(letter) else "\\" + letter for letter in text])


def _zsh(typed: Typed) -> list[str]:
    """Return the word and its description; a blank precedes one that ends its word."""
    candidates = typed.completions()
    width = max((len(candidate.text) for candidate in candidates), default=0)
    return [
        f"{' ' * candidate.closes}{candidate.text}\t{_with_description(candidate, width)}"
        for candidate in candidates
    ]


def _with_description(candidate: Completion, width: int) -> str:
    return (
        f"{candidate.text:{width}}  -- {candidate.description}"
        if candidate.description
        else candidate.text
    )


def _fish(typed: Typed) -> list[str]:
    return [f"{candidate.text}\t{candidate.description}" for candidate in typed.completions()]


WRITERS: "dict[str, Callable[[Typed], list[str]]]" = {"bash": _bash, "zsh": _zsh, "fish": _fish}
