"""Tuples with named fields, whose classes cost next to nothing.

`typing.NamedTuple` compiles a function for every class as it is defined, which takes a tenth of an
answer: modules that many calls load take theirs from here.
"""

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from typing import NamedTuple as NamedTuple
else:
    from operator import itemgetter
    from types import FunctionType

    class NamedTuple(tuple):
        """The same as that of `typing`."""

        def __init_subclass__(cls):
            """Make a property of each field, and a constructor that takes the fields."""
            if NamedTuple not in cls.__bases__:
                return
            cls._fields = cls.__match_args__ = fields = tuple(cls.__annotations__)
            defaults = tuple([vars(cls)[name] for name in fields if name in vars(cls)])
            cls.__new__ = _constructor(cls.__qualname__, fields, defaults)
            for place, name in enumerate(fields):
                setattr(cls, name, property(itemgetter(place)))

        def __getnewargs__(self):
            """Give a copy its fields one by one."""
            return tuple(self)

        def __repr__(self):
            """Show every field with its name."""
            texts = [f"{name}={value!r}" for name, value in self._asdict().items()]
            return f"{type(self).__name__}({', '.join(texts)})"

        def _asdict(self):
            return dict(zip(self._fields, self, strict=True))

        def _replace(self, **changed):
            replaced = tuple.__new__(type(self), map(changed.pop, self._fields, self))
            if changed:
                raise TypeError(f"{type(self).__name__} has no {', '.join(changed)}")
            return replaced

    def _constructor(name, fields, defaults):
        """Return a copy of `_new` with the fields as its first parameters."""
        others = _PARAMETERS[len(fields) :]
        code = _new.__code__.replace(
            co_varnames=("cls", *fields, *others),
            co_argcount=1 + len(fields),
            co_kwonlyargcount=len(others),
            co_filename="<fields>",
            co_qualname=name,
        )
        new = FunctionType(code, {"make": tuple.__new__, "count": len(fields)}, argdefs=defaults)
        new.__kwdefaults__ = dict.fromkeys(others)
        return new

    def _new(cls, a, b, c, d, e, f, g, h, i, j, k, m, n, o, p, q, r, s, t, u, v, w, x, y):
        """Make a tuple of as many arguments as a class has fields, at most 24."""
        fields = a, b, c, d, e, f, g, h, i, j, k, m, n, o, p, q, r, s, t, u, v, w, x, y
        return make(cls, fields[:count])  # noqa: F821

    # With a blank, so that no call can name those that a class has no fields for.
    _PARAMETERS = tuple([f" {name}" for name in _new.__code__.co_varnames[1:]])
