"""Kernels in exact or 50-digit arithmetic.

A family is the shape w(q) on 0 <= q < 1, q = r/h, h the full support radius, and the kernel is
W(r) = a w(q) / h^d with the constant a that makes its integral over R^d one. Polynomial shapes are
kept as fractions and stay exact for a rational q; the others are evaluated as decimals.
"""

from decimal import Decimal, getcontext
from fractions import Fraction

getcontext().prec = 60  # ten digits more than the fifty that are meant

PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494")


def decimal(x):
    """A fraction as a decimal; decimals and integers pass through."""
    return Decimal(x.numerator) / Decimal(x.denominator) if isinstance(x, Fraction) else Decimal(x)


def like(x, model):
    """x in the arithmetic of `model`: a decimal if that is one, else a fraction."""
    return decimal(x) if isinstance(model, Decimal) else x


def horner(coefficients, q):
    value = like(Fraction(0), q)
    for c in reversed(coefficients):
        value = value * q + like(c, q)
    return value


class Polynomial:
    """Piecewise polynomial: pieces of (upper end of q, coefficients of 1, q, q^2, ...)."""

    exact = True

    def __init__(self, *pieces):
        self.pieces = [(Fraction(end), [Fraction(c) for c in coefficients]) for end, coefficients in pieces]

    def _piece(self, q):
        return next((c for end, c in self.pieces if q < like(end, q)), [])

    def shape(self, q):
        return horner(self._piece(q), q)

    def first(self, q):
        return horner([k * c for k, c in enumerate(self._piece(q))][1:], q)

    def integral(self, power):
        """Integral of q^power w(q) over 0 <= q <= 1, exact."""
        total, start = Fraction(0), Fraction(0)
        for end, coefficients in self.pieces:
            for k, c in enumerate(coefficients):
                total += c * (end ** (k + power + 1) - start ** (k + power + 1)) / (k + power + 1)
            start = end
        return total

    def normalisation(self, dimension):
        """Exact in one dimension, 50 digits in two."""
        if dimension == 1:
            return 1 / (2 * self.integral(0))
        return 1 / (2 * PI * decimal(self.integral(1)))


class Mollifier:
    """exp(-1/(1-q^2)) (1-q^2)^m: the mollifier (m = 0) and the modified mollifier (m = 8)."""

    exact = False

    def __init__(self, m):
        self.m = m

    def shape(self, q):
        if q >= 1:
            return Decimal(0)
        s = 1 - q * q
        return (-1 / s).exp() * s**self.m

    def first(self, q):
        if q >= 1:
            return Decimal(0)
        s = 1 - q * q
        return self.shape(q) * (-2 * q / s**2 - 2 * self.m * q / s)

    def normalisation(self, dimension):
        """Trapezoidal sums of integrands that decay doubly exponentially, so they converge to all digits."""
        step = Decimal(1) / 64
        if dimension == 1:
            # q = tanh t: 1 - q^2 = 1/cosh^2 t, so the integral over (-1, 1) is that of
            # exp(-cosh^2 t) / cosh^(2m+2) t over the line.
            def integrand(t):
                c = (t.exp() + (-t).exp()) / 2
                return (-c * c).exp() / c ** (2 * self.m + 2)

            return 1 / (step * sum(integrand(k * step) for k in range(-256, 257)))

        # 2 pi times the integral of q w dq = pi times that of exp(-z) z^(-m-2) over (1, oo),
        # z = 1/(1 - q^2) = 1 + exp(y - exp(-y)).
        def integrand(y):
            f = (y - (-y).exp()).exp()
            return (-1 - f).exp() * (1 + f) ** (-self.m - 2) * f * (1 + (-y).exp())

        return 1 / (PI * step * sum(integrand(k * step) for k in range(-384, 385)))


class Gaussian:
    """exp(-(c q)^2), cut at q = 1 and normalised over what is left."""

    exact = False

    def __init__(self, cut):
        self.cut = cut

    def shape(self, q):
        return (-((self.cut * q) ** 2)).exp() if q < 1 else Decimal(0)

    def first(self, q):
        return -2 * self.cut**2 * q * self.shape(q)

    def normalisation(self, dimension):
        c = Decimal(self.cut)
        if dimension == 2:
            return c**2 / (PI * (1 - (-c * c).exp()))
        # sqrt(pi) erf(c) = 2 exp(-c^2) sum of 2^k c^(2k+1) / (1 3 5 ... (2k+1)), all terms positive
        term, total, k = c, Decimal(0), 0
        while term > Decimal("1e-58"):
            total, k = total + term, k + 1
            term *= 2 * c * c / (2 * k + 1)
        return c / (2 * (-c * c).exp() * total)


KERNELS = {
    "lucy": Polynomial((1, [1, 0, -6, 8, -3])),  # (1 + 3q)(1 - q)^3
    "cubic-spline": Polynomial(  # 1 - 3/2 s^2 + 3/4 s^3, then (2 - s)^3 / 4, s = 2q
        (Fraction(1, 2), [1, 0, -6, 6]),
        (1, [2, -6, 6, -2]),
    ),
    "quadratic": Polynomial((1, [1, -2, 1])),  # (1 - q)^2
    "wendland-c2": Polynomial((1, [1, 0, -10, 20, -15, 4])),  # (1 + 4q)(1 - q)^4
    "mollifier": Mollifier(0),
    "modified-mollifier": Mollifier(8),
    "gaussian": Gaussian(3),
}
