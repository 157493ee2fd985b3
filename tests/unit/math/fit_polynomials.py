#!/usr/bin/env python3
"""Fits the polynomials of math/*.h: python3 tests/unit/math/fit_polynomials.py (needs mpmath).

Each is the polynomial p of least maximal |p(x) - g(x)| weight(x) on an interval (Remez' exchange), its coefficients
then rounded to double. Printed: the coefficients, constant first, and the maximal weighted error after rounding.
"""
from mpmath import mp, mpf, matrix, lu_solve, cos, expm1, log, log1p, pi, sqrt

mp.dps = 60


def evaluate(coefficients, x):
    result = mpf(0)
    for c in reversed(coefficients):
        result = result * x + c
    return result


def fit(g, weight, lo, hi, degree):
    lo, hi = mpf(lo), mpf(hi)
    count = degree + 2
    nodes = [(lo + hi) / 2 - (hi - lo) / 2 * cos(pi * i / (count - 1)) for i in range(count)]
    samples = [(lo + hi) / 2 - (hi - lo) / 2 * cos(pi * i / (40 * count)) for i in range(40 * count + 1)]
    g_samples = [g(x) for x in samples]
    w_samples = [weight(x) for x in samples]
    for _ in range(12):
        a = matrix(count, count)
        b = matrix(count, 1)
        for row, x in enumerate(nodes):
            for k in range(degree + 1):
                a[row, k] = x**k
            a[row, degree + 1] = (-1) ** row / weight(x)
            b[row] = g(x)
        coefficients = list(lu_solve(a, b))[: degree + 1]
        errors = [(evaluate(coefficients, x) - y) * w for x, y, w in zip(samples, g_samples, w_samples)]
        # One extremum for each run of samples in which the error keeps its sign.
        runs, best = [], 0
        for i in range(1, len(samples)):
            if (errors[i] > 0) != (errors[best] > 0):
                runs.append(best)
                best = i
            elif abs(errors[i]) > abs(errors[best]):
                best = i
        runs.append(best)
        if len(runs) != count:
            break
        nodes = [samples[i] for i in runs]
    return coefficients


def show(title, g, weight, lo, hi, degree):
    rounded = [mpf(float(c)) for c in fit(g, weight, lo, hi, degree)]
    error = mpf(0)
    for i in range(4001):
        x = mpf(lo) + (mpf(hi) - mpf(lo)) * i / 4000
        error = max(error, abs((evaluate(rounded, x) - g(x)) * weight(x)))
    print(f"{title}: degree {degree} on [{float(lo):.6g}, {float(hi):.6g}], error {float(error):.3g} = 2^{float(log(error, 2)):.1f}")
    print("  " + ", ".join(float(c).hex() for c in rounded))


def series(term, count):
    """sum over j of term(j) x^j, for functions whose closed form cancels near 0."""
    return lambda x: sum(term(j) * x**j for j in range(count))


ln2 = log(2)
one = lambda x: mpf(1)
relative = lambda g: lambda x: 1 / abs(g(x))

log2_over_t = lambda t: log1p(t) / (ln2 * t) if t else 1 / ln2
for d in (8, 11, 19, 20):
    show("log2(1 + t) / t", log2_over_t, relative(log2_over_t), sqrt(mpf(1) / 2) - 1, sqrt(mpf(2)) - 1, d)

# log2((1 + z) / (1 - z)) = z (A + w (A/3 + w q(w))), w = z^2, A = 2 / ln 2; |z| <= (sqrt(3/2) - 1) / (sqrt(3/2) + 1)
z_max = (sqrt(mpf(3) / 2) - 1) / (sqrt(mpf(3) / 2) + 1)
for d in (4, 5, 6):
    show("log2 tail q(w)", series(lambda j: 2 / (ln2 * (2 * j + 5)), 40), lambda w: max(w * w, mpf("1e-8")), 0, z_max**2 * mpf("1.0001"), d)

exp2_minus_1 = lambda f: expm1(f * ln2) / f if f else ln2
for d in (4, 5, 6, 9, 10, 11):
    show("(2^f - 1) / f", exp2_minus_1, one, mpf(-1) / 2, mpf(1) / 2, d)

exp2_tail = series(lambda j: ln2 ** (j + 2) / mp.factorial(j + 2), 30)
for d in (8, 9, 10):
    show("(2^f - 1 - f ln2) / f^2", exp2_tail, one, mpf(-1) / 2, mpf(1) / 2, d)

atan_tail = series(lambda j: mpf(-1) ** (j + 1) / (2 * j + 3), 90)
for d in (3, 4, 10, 11):
    show("(atan(a) / a - 1) / a^2", atan_tail, lambda w: max(w, mpf("1e-6")), 0, (sqrt(mpf(2)) - 1) ** 2 * mpf("1.0001"), d)

factorial = mp.factorial
sin_tail = series(lambda j: mpf(-1) ** (j + 1) / factorial(2 * j + 3), 20)
cos_tail = series(lambda j: mpf(-1) ** j / factorial(2 * j + 4), 20)
quarter = (pi / 4) ** 2 * mpf("1.0001")
show("(sin(x) / x - 1) / x^2", sin_tail, one, 0, quarter, 6)
show("(cos(x) - 1 + x^2/2) / x^4", cos_tail, one, 0, quarter, 5)

for name, value in (("log2(1.5)", log(mpf(3) / 2, 2)), ("2/ln2", 2 / ln2), ("2/(3 ln2)", 2 / (3 * ln2)), ("1/ln2", 1 / ln2),
                    ("ln2", ln2), ("pi/4", pi / 4), ("pi/2", pi / 2), ("pi", pi), ("pi/180", pi / 180)):
    high = float(value)
    print(f"{name} = {high.hex()} + {float(value - mpf(high)).hex()}")
