"""Kernels of one's own against closed forms, published figures and the kernels that are built in."""

from __future__ import annotations

import math
import signal
import subprocess
import sys
import textwrap
from decimal import Decimal
from typing import Any

import numpy as np
import pytest

import shtaerman as st

X = np.linspace(-1.0, 1.0, 21)


def solved(kernel: st.Kernel, **keywords: Any) -> st.EquationAnswer:
    return st.equation(**{"kind": "second", "lambda_": 1.0, "rhs": 1.0, "kernel": kernel, "at": X, **keywords})


def love(separation: float) -> st.Kernel:
    return st.Kernel(lambda x, s: separation / (math.pi * (separation**2 + (x - s) ** 2)), even=True)


@pytest.mark.parametrize("lambda_", [0.7, 5.0, -0.4])
def test_a_kernel_of_rank_two(lambda_: float) -> None:
    """K = x s + exp(x + s) on (0, 2): phi = f - lambda (c x + d exp(x)) with a system of two equations for c = int s phi ds, d = int exp(s) phi ds."""
    kernel = st.Kernel(lambda x, s: x * s + math.exp(x + s), interval=(0.0, 2.0))
    x = np.linspace(0.0, 2.0, 17)
    found = st.equation(kind="second", kernel=kernel, lambda_=lambda_, rhs="1 + x^2", at=x)
    e2, e4 = math.exp(2.0), math.exp(4.0)
    # Integrals over (0, 2): s^2, s exp(s), exp(2s); s f, exp(s) f.
    gram = np.array([[8 / 3, e2 + 1], [e2 + 1, (e4 - 1) / 2]])
    moments = np.array([2 + 4, (e2 - 1) + (2 * e2 - 2)])
    c, d = np.linalg.solve(np.eye(2) + lambda_ * gram, moments)
    expected = 1 + x**2 - lambda_ * (c * x + d * np.exp(x))
    assert found.error.solution_sup is not None and found.error.solution_sup < 1e-10 * np.abs(expected).max()
    assert np.abs(found.phi - expected).max() <= found.error.solution_sup
    # int f - lambda (c int x + d int exp).
    integral = 2 + 8 / 3 - lambda_ * (2 * c + d * (e2 - 1))
    assert found.integral == pytest.approx(integral, abs=found.error.integral)


def test_loves_equation_as_published() -> None:
    """L. Fox and E. T. Goodwin (1953), P. Abbott: phi(0) and phi(1) for disks at the distance of their radius."""
    for sign, middle, end in [(1.0, 0.6574114, 0.7557182), (-1.0, 1.9190320, 1.6396952)]:
        found = solved(love(1.0), lambda_=sign, at=[0.0, 1.0])
        # The published series have seven digits, the last of them off by one.
        assert found.phi == pytest.approx([middle, end], abs=2e-7)


def test_the_gas_of_lieb_and_liniger() -> None:
    """gamma = 2 pi kappa/int phi and e = gamma^3/(2 pi kappa^3) int x^2 phi; for strong repulsion e = pi^2/3 (gamma/(gamma + 2))^2 (1 + 32 pi^2/(15 (gamma + 2)^3) + ..)."""
    kappa = 600.0
    nodes, weights = np.polynomial.legendre.leggauss(20)
    found = solved(love(kappa), lambda_=-1.0, at=nodes)
    assert found.integral is not None
    gamma = 2 * math.pi * kappa / found.integral
    energy = gamma**3 / (2 * math.pi * kappa**3) * (weights @ (nodes**2 * found.phi))
    strong = math.pi**2 / 3 * (gamma / (gamma + 2)) ** 2 * (1 + 32 * math.pi**2 / (15 * (gamma + 2) ** 3))
    assert energy == pytest.approx(strong, rel=1e-12)


@pytest.mark.parametrize("rhs", ["exp(x)", "abs(x - 0.3)", "cos(3*x)"])
def test_the_logarithm_is_that_of_the_library(rhs: str) -> None:
    own = st.Kernel(lambda x, s, distance: (-1.0, 0.0), interval=(-0.7, 0.7), singularity="logarithm", even=True)
    x = np.linspace(-0.7, 0.7, 15)
    known = st.equation(kind="second", lambda_=2.0, rhs=rhs, kernel="log", a=0.7, at=x)
    found = solved(own, lambda_=2.0, rhs=rhs, at=x)
    assert known.error.solution_sup is not None and found.error.solution_sup is not None
    allowed = known.error.solution_sup + found.error.solution_sup
    assert allowed < 1e-10 and np.abs(found.phi - known.phi).max() <= allowed
    assert found.answer["rhs"] == rhs and found.method.name == "sinc" and found.error.kind == "estimate"


@pytest.mark.parametrize("mu", [0.3, 0.45])
def test_a_power_is_that_of_the_library(mu: float) -> None:
    own = st.Kernel(lambda x, s, distance: (1.0, 0.0), singularity=mu, even=True)
    known = st.equation(kind="second", lambda_=0.6, rhs="1 + x", kernel="power", a=1.0, mu=mu, at=X)
    found = solved(own, lambda_=0.6, rhs=lambda x: 1 + x)
    assert known.error.solution_sup is not None and found.error.solution_sup is not None
    assert found.error.solution_sup < 1e-6
    assert np.abs(found.phi - known.phi).max() <= known.error.solution_sup + found.error.solution_sup
    assert found.answer["kernel"] == {"name": "own", "interval": [-1.0, 1.0], "exponent": mu} and found.answer["rhs"] is None


def test_a_power_that_only_bends() -> None:
    """|x - s|^(1/2) with phi = 1: f = 1 + lambda int |x - s|^(1/2) ds = 1 + 2 lambda/3 ((1 + x)^(3/2) + (1 - x)^(3/2))."""
    own = st.Kernel(lambda x, s, distance: (1.0, 0.0), singularity=-0.5, even=True)
    found = solved(own, lambda_=0.25, rhs="1 + 2*0.25/3*((1 + x)^1.5 + (1 - x)^1.5)")
    assert found.error.solution_sup is not None and found.error.solution_sup < 1e-8
    assert np.abs(found.phi - 1.0).max() <= found.error.solution_sup


def test_a_rough_layer_is_a_contact() -> None:
    """ln coth(pi d/(4 h)), the layer under antiplane shear: far below the surface it is the half-plane of the gauge 4 h/pi."""
    h = 400.0

    def split(x: float, s: float, distance: float) -> tuple[float, float]:
        z = 0.25 * math.pi * distance / h
        # ln coth z + ln z, which is z^2/3 + O(z^4).
        return -1.0, math.log(4 * h / math.pi) + (z * z / 3 if z < 1e-3 else math.log(z / math.tanh(z)))

    layer = st.Kernel(split, singularity="logarithm", even=True)
    plane = st.Kernel(lambda x, s, d: (-1.0, math.log(4 * h / math.pi)), singularity="logarithm", even=True)
    thick, limit = solved(layer, lambda_=2.0), solved(plane, lambda_=2.0)
    assert thick.integral is not None and limit.integral is not None
    # The rest is of the order (d/h)^2.
    assert thick.integral == pytest.approx(limit.integral, rel=1e-5) and thick.integral != limit.integral


def test_shapes_points_and_nothing() -> None:
    kernel = love(1.0)
    grid = solved(kernel, at=X[:20].reshape(4, 5))
    assert grid.phi.tolist() == solved(kernel).phi[:20].reshape(4, 5).tolist() and grid.x.shape == (4, 5)
    curve = solved(kernel, at=None, points=33)
    assert curve.x.shape == (33,) and curve.x[[0, -1]].tolist() == [-1.0, 1.0] and (np.diff(curve.x) > 0).all()
    built_in = st.equation(kind="second", lambda_=1.0, rhs=1, kernel="log", a=1.0, points=33)
    assert curve.x.tolist() == built_in.x.tolist()
    # Nothing given, nothing found; a kernel that is 0 is one, too.
    assert (solved(kernel, rhs=0.0).phi == 0.0).all()
    zero = st.Kernel(lambda x, s: 0.0)
    assert solved(zero, rhs="x").phi.tolist() == X.tolist()
    # So are kernels that vanish on the diagonal, or at a place of it.
    for kernel in (st.Kernel(lambda x, s: (x - s) ** 2), st.Kernel(lambda x, s: x + s), st.Kernel(lambda x, s: x * s)):
        assert solved(kernel, lambda_=0.1).phi.shape == (21,)


def test_numbers_of_every_kind_serve() -> None:
    expected = solved(st.Kernel(lambda x, s: 1.0)).phi
    assert expected == pytest.approx(1 / 3, rel=1e-12)
    for one in (1, np.float64(1), np.float32(1), np.int8(1), np.array(1.0), Decimal(1)):
        assert solved(st.Kernel(lambda x, s: one), rhs=lambda x: one).phi.tolist() == expected.tolist()
    for both in ((-1, 0), [-1.0, 0.0], np.array([-1.0, 0.0])):
        assert solved(st.Kernel(lambda x, s, d: both, singularity="logarithm")).phi.shape == (21,)


RUBBISH: list[tuple[Any, str]] = [
    (lambda x, s: math.nan, "kernel: must give one finite number, got nan at x = "),
    (lambda x, s: 1 / (x - s) if x != s else math.inf, "got inf"),
    (lambda x, s: 1j, "got 1j"),
    (lambda x, s: np.complex128(1.0), "one finite number"),
    (lambda x, s: np.complex64(1.0), "one finite number"),
    (lambda x, s: None, "got None"),
    (lambda x, s: "1", "got '1'"),
    (lambda x, s: True, "got True"),
    (lambda x, s: np.True_, "one finite number"),
    (lambda x, s: [1.0], r"got \[1.0\]"),
    (lambda x, s: np.ones(1), "one finite number"),
    (lambda x, s: (1.0, 0.0), r"got \(1.0, 0.0\)"),
    (lambda x, s: 10**400, "one finite number"),
    (lambda x, s: x, "symmetric .* differ"),
    (lambda x, s: x - s, "symmetric .* differ"),
    (lambda x, s: 1.0 if x == s else 2.0, "beside x = s"),
    (lambda x, s: math.log(abs(x - s)) if x != s else 0.0, "beside x = s"),
]
RUBBISH_OF_SPLITS: list[tuple[Any, str]] = [
    (lambda x, s, d: 1.0, r"must give a pair \(A, B\) of finite numbers, got 1.0"),
    (lambda x, s, d: (1.0,), "a pair"),
    (lambda x, s, d: (1.0, 0.0, 0.0), "a pair"),
    (lambda x, s, d: (1.0, math.nan), "a pair"),
    (lambda x, s, d: (1.0, [0.0]), "a pair"),
    (lambda x, s, d: "ab", "a pair"),
    (lambda x, s, d: None, "got None"),
    (lambda x, s, d: (-1.0, x), "symmetric .* differ"),
    # The singular part left in the rest.
    (lambda x, s, d: (-1.0, math.log(d) if d > 0 else 0.0), "the split is wrong"),
]


@pytest.mark.parametrize(("function", "said"), RUBBISH)
def test_rubbish_for_a_kernel_is_refused(function: Any, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        solved(st.Kernel(function))


@pytest.mark.parametrize(("function", "said"), RUBBISH_OF_SPLITS)
def test_rubbish_for_a_split_is_refused(function: Any, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        solved(st.Kernel(function, singularity="logarithm"))


def test_a_kernel_that_is_not_even() -> None:
    with pytest.raises(ValueError, match="even = True, but"):
        solved(st.Kernel(lambda x, s: math.exp(x + s), even=True))


def test_what_callables_raise_is_raised() -> None:
    class Own(Exception):
        pass

    calls = 0

    def late(x: float, s: float) -> float:
        nonlocal calls
        calls += 1
        if calls > 2000:
            raise Own("late")
        return 1.0

    def broken(*_: float) -> float:
        raise Own("here")

    for kernel, rhs in [(st.Kernel(broken), "1"), (st.Kernel(lambda x, s: 1.0), broken), (st.Kernel(late), "1")]:
        with pytest.raises(Own):
            solved(kernel, rhs=rhs)
    # After the first exception nobody is asked any more.
    assert calls == 2001
    with pytest.raises(TypeError, match="argument"):
        solved(st.Kernel(lambda x: 1.0))  # type: ignore[arg-type, misc]


@pytest.mark.parametrize(
    ("keywords", "said"),
    [
        ({"function": 1.0}, "got float"),
        ({"interval": (1.0, -1.0)}, "the left one first"),
        ({"interval": (0.0, 0.0)}, "the left one first"),
        ({"interval": (0.0, math.inf)}, "finite ends"),
        ({"interval": (math.nan, 1.0)}, "finite ends"),
        ({"interval": (0.0, 1.0, 2.0)}, "a pair"),
        ({"interval": "ab"}, "real numbers"),
        ({"singularity": "log"}, "'logarithm' or an exponent"),
        ({"singularity": 1.0}, "between -1 and 1"),
        ({"singularity": 0.0}, "not 0"),
        ({"singularity": math.nan}, "got nan"),
        ({"singularity": True}, "got True"),
        ({"even": 1}, "True or False"),
    ],
)
def test_what_is_no_kernel(keywords: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        st.Kernel(**{"function": lambda x, s: 1.0, **keywords})


@pytest.mark.parametrize(
    ("keywords", "said"),
    [
        ({"kind": "first"}, "must be 'second'"),
        ({"kind": None}, "must be 'second'"),
        ({"lambda_": None}, "lambda_: is None"),
        ({"lambda_": math.nan}, "lambda_: is nan"),
        ({"lambda_": "1"}, "lambda_: is '1'"),
        ({"lambda_": [1.0]}, "lambda_"),
        ({"rhs": None}, "rhs: is missing"),
        ({"rhs": math.inf}, "rhs: is inf"),
        ({"rhs": "y"}, "rhs: .*y"),
        ({"rhs": "1/x"}, "infinite at x = 0"),
        ({"rhs": lambda x: math.nan}, "rhs: must give one finite number, got nan at x = "),
        ({"rhs": lambda x: [x]}, "rhs: must give one finite number"),
        ({"rhs": [1.0]}, "rhs"),
        ({"a": 1.0}, "a: does not go with"),
        ({"cross_check": True}, "cross_check: does not go"),
        ({"solver": {"n": 40}}, "solver.n"),
        ({"solver": {"method": "spectral"}}, "collocation"),
        ({"solver": {"tolerance": 2.0}}, "tolerance"),
        ({"solver": {"tolerance": "small"}}, "tolerance"),
        ({"at": [1.5]}, "beyond the interval"),
        ({"at": [math.nan]}, "beyond"),
        ({"at": ["a"]}, "real numbers"),
        ({"at": None, "points": 1}, "points"),
    ],
)
def test_what_is_no_equation(keywords: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        solved(love(1.0), **keywords)
    with pytest.raises(ValueError, match="does not go with"):
        st.equation({"equation": {}}, kind="second", kernel=love(1.0), lambda_=1.0, rhs=1.0)


def test_promises_that_cannot_be_kept() -> None:
    with pytest.raises(st.ConvergenceError, match="tolerance 1e-17 was not met"):
        solved(love(1.0), solver={"tolerance": 1e-17})
    assert solved(love(1.0), solver={"tolerance": 1e-6, "method": "sinc"}).error.solution_sup is not None
    # 1 + lambda K with K = 1 is singular for lambda = -1/2.
    with pytest.raises((st.ConvergenceError, ValueError), match="eigenvalue|singular"):
        solved(st.Kernel(lambda x, s: 1.0), lambda_=-0.5)
    # A kink that is not stated costs digits, and the answer says so.
    kinked = solved(st.Kernel(lambda x, s: abs(x - s) ** 1.0), lambda_=0.3, rhs=1.0)
    assert kinked.error.solution_sup is not None
    # phi'' + 2 lambda phi = f'' for |x - s|, with phi even: phi = C cos(k x), k^2 = 2 lambda, and phi(0) + 2 lambda int_0^1 s phi = 1.
    k = math.sqrt(0.6)
    inner = math.sin(k) / k + (math.cos(k) - 1) / k**2
    exact = np.cos(k * X) / (1 + 0.6 * inner)
    assert np.abs(kinked.phi - exact).max() <= kinked.error.solution_sup


def test_a_slow_callable_can_be_interrupted() -> None:
    program = textwrap.dedent(
        """
        import math, time
        import shtaerman as st
        said = False
        def slow(x, s):
            global said
            if not said:
                print("go", flush=True)
                said = True
            time.sleep(1e-3)
            return math.exp(-(x - s) ** 2)
        try:
            st.equation(kind="second", kernel=st.Kernel(slow), lambda_=1.0, rhs=1.0)
            print("solved")
        except KeyboardInterrupt:
            print("interrupted")
        """
    )
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None and process.stdout.readline() == "go\n"
        process.send_signal(signal.SIGINT)
        assert process.stdout.readline() == "interrupted\n"


def test_what_a_kernel_says() -> None:
    kernel = st.Kernel(math.hypot, interval=[0, 2])
    assert kernel.function is math.hypot and kernel.interval == (0.0, 2.0) and kernel.singularity is None and not kernel.even
    assert repr(kernel) == "<Kernel: smooth on (0.0, 2.0)>"
    assert "|x - s|^-0.5" in repr(st.Kernel(math.hypot, singularity=0.5))
    assert "logarithm" in repr(st.Kernel(math.hypot, singularity="logarithm"))
