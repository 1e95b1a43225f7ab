"""Writes free/*.json: torque-free cases beyond the open ones, to 34 digits, from closed forms at 150 digits (needs mpmath).

    python3 make_free.py            # writes the cases
    python3 make_free.py --check    # recomputes every torque-free case in this folder instead, and prints the differences

The attitude comes from theta series in the squared nome, at a precision at which their cancellation near the separatrix
does not matter; the library sums them otherwise there (by the other nome, in double-double). Exact symmetry, spin about
one axis and the exact separatrix have forms of their own here too. Keys are those of the cases in the folder above.
"""
import glob
import json
import os
import sys

import mpmath as mp

mp.mp.dps = 150
HERE = os.path.dirname(os.path.abspath(__file__))


def times(a, b):
    return [a[0]*b[0] - a[1]*b[1] - a[2]*b[2] - a[3]*b[3], a[0]*b[1] + a[1]*b[0] + a[2]*b[3] - a[3]*b[2],
            a[0]*b[2] - a[1]*b[3] + a[2]*b[0] + a[3]*b[1], a[0]*b[3] + a[1]*b[2] - a[2]*b[1] + a[3]*b[0]]


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def about(axis, half):
    """The rotation by twice `half` about a vector, which must not be zero."""
    size = mp.sqrt(sum(x*x for x in axis))
    return [mp.cos(half)] + [mp.sin(half)*x/size for x in axis]


def to_world(q, v):
    return times(times(q, [mp.mpf(0)] + list(v)), conjugate(q))[1:]


def uniform(I, w, q0):
    size = mp.sqrt(sum(x*x for x in w))
    return lambda t: (times(q0, about(w, size*t/2)) if size else q0, w)


def symmetric(I, w, q0, axis):
    """I equal but for `axis`."""
    transverse = I[(axis + 1) % 3]
    L = [i*x for i, x in zip(I, w)]
    e = [mp.mpf(k == axis) for k in range(3)]
    about_L, about_e = mp.sqrt(sum(x*x for x in L))/transverse/2, (1 - I[axis]/transverse)*w[axis]/2

    def at(t):
        spin = about(e, about_e*t)
        return times(times(q0, about(L, about_L*t)), spin), to_world(conjugate(spin), w)
    return at


def tri_axial(I, w, q0):
    """I ascending."""
    D = sum(I[j]*(I[j] - I[1])*w[j]**2 for j in range(3))
    h = mp.sqrt(mp.mpf(1)/2)
    if D >= 0:
        J, W, r = I[:], w[:], [mp.mpf(1), 0, 0, 0]
    else:
        J, W, r = [I[2], I[1], I[0]], [-w[2], w[1], w[0]], [h, 0, h, 0]
    if W[2] < 0:
        W, r = [W[0], -W[1], -W[2]], times(r, [0, mp.mpf(1), 0, 0])
    if W[0] < 0:
        W, r = [-W[0], -W[1], W[2]], times(r, [0, 0, 0, mp.mpf(1)])
    D3 = J[0]*(J[2] - J[0])*W[0]**2 + J[1]*(J[2] - J[1])*W[1]**2
    D1 = J[1]*(J[1] - J[0])*W[1]**2 + J[2]*(J[2] - J[0])*W[2]**2
    D2 = J[2]*(J[2] - J[1])*W[2]**2 - J[0]*(J[1] - J[0])*W[0]**2
    sg = 1 if J[2] > J[0] else -1
    w10 = mp.sqrt(D3/(J[0]*(J[2] - J[0])))
    w20 = sg*mp.sqrt(D3/(J[1]*(J[2] - J[1])))
    w30 = mp.sqrt(D1/(J[2]*(J[2] - J[0])))
    rate = mp.sqrt(D1*(J[2] - J[1])/(J[0]*J[1]*J[2]))
    m1 = (J[2] - J[0])*D2/(D1*(J[2] - J[1]))
    m = D3*(J[1] - J[0])/(D1*(J[2] - J[1]))
    L, T2 = mp.sqrt(sum((J[j]*W[j])**2 for j in range(3))), sum(J[j]*W[j]**2 for j in range(3))
    cn, sn, dn = W[0]/w10, W[1]/w20, W[2]/w30
    u0 = sn*mp.elliprf(cn**2, dn**2, 1)
    c, half_tangent = J[2]*w30/L, J[0]*w10/L/(1 + J[2]*w30/L)
    half_rate = (T2 + L*w30)/(L + J[2]*w30)/2

    if D2 == 0:      # the separatrix: tanh and sech, and a theta pair of two terms
        beta = sg*mp.atan(half_tangent)
        mu = half_rate + rate/2*mp.tan(beta)

        def pair(t):
            up, down = mp.exp((u0 + rate*t)/2), mp.exp(-(u0 + rate*t)/2)
            ahead, behind = up*mp.expj(-beta), down*mp.expj(beta)
            return ahead + behind, sg*(ahead - behind), mu*t

        def omega(t):
            u = u0 + rate*t
            return [w10*mp.sech(u), w20*mp.tanh(u), w30*mp.sech(u)]
    else:
        K, Kp = mp.pi/2/mp.agm(1, mp.sqrt(m1)), mp.pi/2/mp.agm(1, mp.sqrt(m))
        s2 = (J[0]*w10/L)**2/(1 - c**2*m1)
        s = sg*mp.pi*mp.sqrt(s2)*mp.elliprf(1 - s2, 1 - m1*s2, 1)/(2*K)
        Q = mp.exp(-2*mp.pi*Kp/K)
        terms = 4 + int(mp.sqrt(mp.mp.prec*mp.log(2)/-mp.log(Q))) + int(abs(2*s/mp.log(Q)))
        dlog = 4*sum((-1)**n*n*Q**(n*n)*mp.sinh(2*n*s) for n in range(1, terms)) / \
            (1 + 2*sum((-1)**n*Q**(n*n)*mp.cosh(2*n*s) for n in range(1, terms)))
        mu = half_rate - mp.pi*rate/(2*K)*dlog
        v0, fv = mp.pi*u0/(2*K), mp.pi*rate/(2*K)

        def thetas(v):
            z = v - 1j*s
            return (1 + 2*sum((-1)**n*Q**(n*n)*mp.cos(2*n*z) for n in range(1, terms)),
                    sum((-1)**n*Q**(n*n + n)*mp.sin((2*n + 1)*z) for n in range(terms)))
        a, b = thetas(mp.mpf(0))
        zeta = sg*half_tangent*abs(a)/abs(b)

        def pair(t):
            a, b = thetas(v0 + fv*t)
            return a, zeta*b, mu*t

        def omega(t):
            v = v0 + fv*t
            q = mp.sqrt(Q)
            th = [mp.jtheta(k, mp.fmod(v, 2*mp.pi), q) for k in (1, 2, 3, 4)]
            at0 = [mp.jtheta(k, 0, q) for k in (1, 2, 3, 4)]
            return [w10*at0[3]/at0[1]*th[1]/th[3], w20*at0[2]/at0[1]*th[0]/th[3], w30*at0[3]/at0[2]*th[2]/th[3]]

    def in_L_frame(t):
        a, b, phase = pair(t)
        a, b = a*mp.expj(phase), b*mp.expj(phase)
        n = mp.sqrt(abs(a)**2 + abs(b)**2)
        return [x/n for x in (a.real, b.real, b.imag, a.imag)]
    g = times(times(q0, r), conjugate(in_L_frame(mp.mpf(0))))
    return lambda t: (times(times(g, in_L_frame(t)), conjugate(r)), to_world(r, omega(t)))


def motion(I, w, q0):
    """(q, omega in body) as a function of t; everything exact, I in any order."""
    if len(set(I)) == 1 or sum(x != 0 for x in w) < 2:
        return uniform(I, w, q0)
    for axis in range(3):
        if I[(axis + 1) % 3] == I[(axis + 2) % 3]:
            return symmetric(I, w, q0, axis)
    order = sorted(range(3), key=lambda k: I[k])
    h = mp.mpf(1)/2
    r = {(0, 1, 2): [1, 0, 0, 0], (1, 2, 0): [h, h, h, h], (2, 0, 1): [h, -h, -h, -h]}.get(tuple(order))
    if r is None:        # an odd permutation: half a turn about a diagonal exchanges two axes and reverses the third
        s = mp.sqrt(h)
        r = {(1, 0, 2): [0, s, s, 0], (0, 2, 1): [0, 0, s, s], (2, 1, 0): [0, s, 0, s]}[tuple(order)]
    r = [mp.mpf(x) for x in r]
    w_ascending = to_world(conjugate(r), w)
    inner = tri_axial([I[k] for k in order], w_ascending, times(q0, r))

    def at(t):
        q, omega = inner(t)
        return times(q, conjugate(r)), to_world(r, omega)
    return at


def exact(numbers):
    return [mp.mpf(x) for x in numbers]


def unit(q0):
    q = exact(q0)
    n = mp.sqrt(sum(x*x for x in q))
    return [x/n for x in q]


def digits(x):
    return "0" if abs(x) < mp.mpf(10)**-100 else mp.nstr(x, 34, strip_zeros=False, min_fixed=-5, max_fixed=20)


def sample(at, I, t):
    q, w = at(mp.mpf(t))
    q = [-x for x in q] if q[0] < 0 else q
    L = to_world(q, [i*x for i, x in zip(I, w)])
    return {"t": t, "q": [digits(x) for x in q], "omega_body": [digits(x) for x in w], "L_world": [digits(x) for x in L]}


def case(name, description, inertia, omega, t_end, q0=(0.5, -0.5, 0.5, 0.5)):
    at = motion(exact(inertia), exact(omega), unit(q0))
    # Fractions off any grid, so that flips are met at all stages.
    instants = [0.0] + [float(f)*t_end for f in (0.0137, 0.1931, 0.3779, 0.5003, 0.7211, 0.9257, 1.0)]
    record = {
        "schema": "rigid-body-reference/1", "name": name, "family": "free", "description": description, "mass": 1.0,
        "inertia": list(inertia), "q0": list(q0), "q0_unit": [digits(x) for x in unit(q0)], "omega0_body": list(omega),
        "torques": [], "t_end": t_end, "samples": [sample(at, exact(inertia), t) for t in instants],
    }
    with open(os.path.join(HERE, "free", name + ".json"), "w") as file:
        file.write(json.dumps(record, indent=0).replace("\n", " ").replace("{ \"t\"", "\n{ \"t\"") + "\n")
    print(name)


def write():
    T = (0.0003, 0.0002, 0.00015)
    up = lambda x: x*(1 + 2.0**-52)
    case("dzhanibekov_1e-6", "T-handle, both other components 1e-6 of the spin", T, (6e-6, 6.0, 6e-6), 100.0)
    case("dzhanibekov_1e-12", "T-handle, both other components 1e-12 of the spin", T, (6e-12, 6.0, 6e-12), 100.0)
    case("dzhanibekov_1e-12_high", "only the largest moment's component, 1e-12", T, (6e-12, -6.0, 0.0), 100.0)
    case("dzhanibekov_1e-12_low", "only the smallest moment's component, -1e-12", T, (0.0, 6.0, -6e-12), 100.0)
    case("dzhanibekov_1e-3_long", "3000 flips", T, (6e-3, 6.0, -2e-3), 10000.0)
    case("dzhanibekov_1e-30", "a component of 1e-30", (1.0, 2.0, 3.0), (0.0, 1.0, 1e-30), 1000.0)
    case("asymmetric_1e5_turns", "1e5 rotations", (0.9, 2.3, 1.7), (1.1, -2.3, 0.7), 2.4e5)
    case("asymmetric_1e9_s", "1e9 s", (2.0, 1.0, 2.6), (0.3, 0.2, -0.9), 1e9)
    case("asymmetric_low", "L circles the axis of the smallest moment, either end", (3.0, 1.0, 2.0), (0.3, -5.0, 0.4), 50.0)
    case("asymmetric_high", "L circles the axis of the largest moment", (3.0, 1.0, 2.0), (-4.0, 0.5, 1.4), 50.0)
    case("nome_switch_below", "K'/K just above 1/2", (1.0, 2.0, 3.0), (1.0, 0.0, 0.65), 80.0)
    case("nome_switch_above", "K'/K just below 1/2", (1.0, 2.0, 3.0), (1.0, 0.3, 0.62), 80.0)
    case("needle_spin", "1e6 : 1 needle, mostly about its axis", (1e6, 1.0, 1e6 + 0.25), (1e-5, 9.0, -2e-5), 50.0)
    case("needle_tumble", "1e6 : 1 needle, mostly end over end", (1e6, 1.0, 1e6 + 0.5), (1.0, 9.0, 0.5), 50.0)
    case("plate", "exact lamina", (0.75, 2.0, 1.25), (1.0, 0.5, -3.0), 50.0)
    case("plate_near_disc", "a lamina whose small moments differ by 1e-7", (1.0, 2.0000001, 1.0000001), (1.0, 0.1, 2.0), 50.0)
    case("near_equal_low_1e-9", "small moments 1e-9 apart", (1.0, 1.000000001, 1.6), (0.3, -0.8, 2.0), 300.0)
    case("near_equal_low_ulp", "small moments one ulp apart", (1.0, up(1.0), 1.6), (0.3, -0.8, 2.0), 300.0)
    case("near_equal_low_flat", "small moments one ulp apart, L almost across the other axis", (1.0, up(1.0), 1.6), (0.3, 0.8, 1e-9), 3e8)
    case("near_equal_high_1e-9", "large moments 1e-9 apart", (1.6, 1.600000001, 0.7), (1.0, 2.0, -0.4), 300.0)
    case("near_equal_high_ulp", "large moments one ulp apart", (up(1.6), 0.7, 1.6), (1.0, 2.0, -0.4), 300.0)
    case("near_sphere_1e-6", "all within 1e-6", (1.0, 1.000001, 0.9999995), (3.0, -1.0, 2.0), 1e5)
    case("near_sphere_ulp", "all within ulps", (1.0, up(1.0), up(up(1.0))), (3.0, -1.0, 2.0), 1e4)
    case("separatrix", "exactly on it: 3/4 and 1", (1.0, 2.0, 2.25), (0.75, -2.0, 1.0), 20.0)
    case("separatrix_unsorted", "exactly on it, other signs, order and end", (2.25, 1.0, 2.0), (-1.0, 0.75, 1.0), 20.0)
    case("separatrix_ulp", "an ulp off it", (1.0, 2.0, 2.25), (up(0.75), -2.0, 1.0), 200.0)
    case("principal_axis", "spin about the middle axis, which stays", (1.0, 2.0, 3.0), (0.0, -1.3, 0.0), 1e4)
    case("principal_axis_nutation", "1e-9 off the largest moment's axis", (1.0, 2.0, 3.0), (1e-9, -2e-9, 4.0), 1e3)
    case("symmetric_prolate", "long", (0.4, 1.5, 1.5), (5.0, -0.3, 0.6), 1e3)
    case("symmetric_oblate", "flat", (1.5, 2.5, 1.5), (1.0, -3.0, 0.6), 1e3)
    case("symmetric_across", "L exactly across the axis", (1.5, 2.5, 1.5), (1.0, 0.0, 0.6), 1e3)
    case("spherical", "equal moments", (0.1, 0.1, 0.1), (1.0, -3.0, 0.6), 1e7)
    case("slow", "1e-6 rad/s", (3e3, 1e3, 2.2e3), (1e-6, 2e-6, -1e-6), 1e9)
    case("fast", "1e4 rad/s, moments of a small stone", (3e-12, 1e-12, 2.2e-12), (1e4, 7e3, -8e3), 100.0)
    case("rest", "no rotation", (1.0, 2.0, 3.0), (0.0, 0.0, 0.0), 10.0)


def check():
    for path in sorted(glob.glob(os.path.join(HERE, "*.json"))):
        with open(path) as file:
            reference = json.load(file)
        if reference["torques"]:
            continue
        I = exact(reference["inertia"])
        at = motion(I, exact(reference["omega0_body"]), unit(reference["q0"]))
        worst = mp.mpf(0)
        for row in reference["samples"]:
            q, w = at(mp.mpf(row["t"]))
            between = times(conjugate(exact(row["q"])), q)
            worst = max(worst, 2*mp.sqrt(sum(x*x for x in between[1:])))
            worst = max([worst] + [abs(x - mp.mpf(y))/max(map(abs, w)) for x, y in zip(w, row["omega_body"])])
        print("%-28s %s" % (reference["name"], mp.nstr(worst, 3)))


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        check()
    else:
        write()
