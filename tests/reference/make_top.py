"""Writes top/*.json: Lagrange tops to 34 digits, from theta functions at 150 digits (needs mpmath).

    python3 make_top.py            # writes the cases
    python3 make_top.py --check    # recomputes heavy_top_looping.json, a case of another origin, and prints the difference

At this precision nothing has to be done about nearly double roots and nomes near 1, which the library treats apart. With
A = q0 + i q3 and B = q1 + i q2 in a frame whose third axis is up, 2 |A|^2 = 1 + u and 2 |B|^2 = 1 - u, u the cosine of the
tilt; u = u1 + (u2 - u1) sn^2, so A ~ theta1(v - i s1) and B ~ theta2(v - i s2), each turning evenly.
"""
import json
import os
import sys

import mpmath as mp

from make_free import about, conjugate, digits, exact, times, to_world, unit

mp.mp.dps = 150
HERE = os.path.dirname(os.path.abspath(__file__))
TERMS = 60


def upright(A, C, k, q0, w):
    """Gravity along -z, force at +z of the body, k = force times arm; t -> (q, omega in body)."""
    x, y, z = q0[1:]
    g = to_world(conjugate(q0), [0, 0, 1])
    u0, udot = g[2], g[0]*w[1] - g[1]*w[0]
    spin = C*w[2]/A
    a, b = spin, w[0]*g[0] + w[1]*g[1] + spin*g[2]
    beta = 2*k/A
    alpha = w[0]**2 + w[1]**2 + beta*u0
    cubic = [beta, -(alpha + a*a), 2*a*b - beta, alpha - b*b]
    u1, u2, u3 = sorted(mp.re(r) for r in mp.polyroots(cubic, maxsteps=5000, extraprec=2000))
    m, m1 = (u2 - u1)/(u3 - u1), (u3 - u2)/(u3 - u1)
    K, Kp = mp.pi/2/mp.agm(1, mp.sqrt(m1)), mp.pi/2/mp.agm(1, mp.sqrt(m))
    q = mp.exp(-mp.pi*Kp/K)
    sn2 = min(max((u0 - u1)/(u2 - u1), mp.mpf(0)), mp.mpf(1))
    v0 = mp.pi*mp.sqrt(sn2)*mp.elliprf(1 - sn2, 1 - m*sn2, 1)/(2*K)*(-1 if udot < 0 else 1)
    fv = mp.pi*mp.sqrt(beta*(u3 - u1))/2/(2*K)

    def shift(p, of):
        return -1j*mp.pi*mp.sqrt(p)*mp.elliprf(1 - p, 1 - m1*p, 1)/(2*K)*(1 if of >= 0 else -1)
    z1 = shift(max((1 + u1)/(1 + u2), mp.mpf(0)), b + a)
    z2 = shift(min(max((1 - u2)/(1 - u1)/m1, mp.mpf(0)), mp.mpf(1)), b - a)
    half = [2*q**((n + mp.mpf(1)/2)**2) for n in range(TERMS)]

    def theta(v, quarter, slope):
        """theta1 or, a quarter turn on, theta2; or its derivative."""
        v = v + quarter*mp.pi/2
        if slope:
            return sum((-1)**n*(2*n + 1)*half[n]*mp.cos((2*n + 1)*v) for n in range(TERMS))
        return sum((-1)**n*half[n]*mp.sin((2*n + 1)*v) for n in range(TERMS))
    mu1 = (w[2] - a)/2 + (b + a)/(1 + u2)/2 - fv*mp.im(theta(z1, 1, True)/theta(z1, 1, False))
    mu2 = (a - w[2])/2 + (b - a)/(1 - u1)/2 - fv*mp.im(theta(z2, 1, True)/theta(z2, 1, False))
    um = u1 + (u2 - u1)*mp.ellipfun('sn', K/2, m=m)**2
    zeta = mp.sqrt((1 - um)/(1 + um))*abs(theta(mp.pi/4 + z1, 0, False))/abs(theta(mp.pi/4 + z2, 1, False))
    rates = [x/2 for x in times(q0, [0] + list(w))]

    def phase(value, rate, z, quarter):
        small = abs(value) < mp.mpf(10)**-60
        r = rate/theta(v0 + z, quarter, True) if small else value/theta(v0 + z, quarter, False)
        return r/abs(r)
    pA, pB = phase(mp.mpc(q0[0], z), mp.mpc(rates[0], rates[3]), z1, 0), phase(mp.mpc(x, y), mp.mpc(rates[1], rates[2]), z2, 1)

    def at(t):
        v = v0 + fv*t
        tA, tB = pA*mp.expj(mu1*t), pB*mp.expj(mu2*t)*zeta
        a_, b_ = theta(v + z1, 0, False), theta(v + z2, 1, False)
        da, db = fv*theta(v + z1, 0, True) + 1j*mu1*a_, fv*theta(v + z2, 1, True) + 1j*mu2*b_
        a_, b_, da, db = tA*a_, tB*b_, tA*da, tB*db
        r, d = [a_.real, b_.real, b_.imag, a_.imag], [da.real, db.real, db.imag, da.imag]
        n2 = sum(c*c for c in r)
        omega = [2*c/n2 for c in times(conjugate(r), d)[1:]]
        return [c/mp.sqrt(n2) for c in r], omega
    return at


def motion(I, w, q0, force, arm):
    """Any force, the arm along a principal axis about which the body is symmetric."""
    axis = next(k for k in range(3) if arm[k] != 0)
    third = [mp.mpf(k == axis)*mp.sign(arm[axis]) for k in range(3)]
    size = mp.sqrt(sum(f*f for f in force))
    turn = [to_z(third), to_z([-f/size for f in force])]
    inner = upright(I[(axis + 1) % 3], I[axis], size*abs(arm[axis]), times(times(turn[1], q0), conjugate(turn[0])),
                    to_world(turn[0], w))

    def at(t):
        q, omega = inner(t)
        return times(times(conjugate(turn[1]), q), turn[0]), to_world(conjugate(turn[0]), omega)
    return at


def to_z(v):
    """A rotation that takes a unit vector to the third axis."""
    if v[2] < -0.5:
        return times([v[1]*0, 1, 0, 0] if v[0] == v[1] == 0 else about([v[1], -v[0], 0], mp.acos(v[2])/2), [1, 0, 0, 0])
    return unit_of([1 + v[2], v[1], -v[0], mp.mpf(0)])


def unit_of(q):
    n = mp.sqrt(sum(x*x for x in q))
    return [x/n for x in q]


def sample(at, I, t):
    q, w = at(mp.mpf(t))
    L = to_world(q, [i*x for i, x in zip(I, w)])
    return {"t": t, "q": [digits(x) for x in q], "omega_body": [digits(x) for x in w], "L_world": [digits(x) for x in L]}


def angle(p, q):
    return 2*mp.sqrt(sum(x*x for x in times(conjugate(p), q)[1:]))


def case(name, description, inertia, q0, omega, t_end, force=(0.0, 0.0, -4.905), arm=(0.0, 0.0, 0.05)):
    length = sum(x*x for x in q0)**0.5
    q0 = [x/length for x in q0]
    inputs = [list(inertia), list(omega), q0, list(force), list(arm)]

    def of(inputs):
        return motion(exact(inputs[0]), exact(inputs[1]), unit(inputs[2]), exact(inputs[3]), exact(inputs[4]))
    at = of(inputs)
    instants = [0.0] + [float(f)*t_end for f in (0.0137, 0.1931, 0.3779, 0.5003, 0.7211, 0.9257, 1.0)]
    # What one rounding of an input does: each turned up by 2^-53, the largest change of the attitude.
    floor = mp.mpf(0)
    axis = next(k for k in range(3) if arm[k] != 0)
    for group in range(5):
        for k in range(len(inputs[group])):
            if inputs[group][k] == 0 or (group == 0 and k != axis):
                continue
            turned = [exact(g) for g in inputs]
            turned[group][k] *= 1 + mp.mpf(2)**-53
            other = of(turned)
            floor = max([floor] + [angle(at(mp.mpf(t))[0], other(mp.mpf(t))[0]) for t in instants[1:]])
    record = {
        "schema": "rigid-body-reference/1", "name": name, "family": "heavy-top", "description": description, "mass": 1.0,
        "inertia": inputs[0], "q0": inputs[2], "q0_unit": [digits(x) for x in unit(q0)], "omega0_body": inputs[1],
        "torques": [{"kind": "heavy_top", "mass": 1.0, "r_cm_body": inputs[4], "gravity_world": inputs[3]}],
        "t_end": t_end, "conditioning": {"f64_floor_rad": float(mp.nstr(floor, 3))},
        "samples": [sample(at, exact(inertia), t) for t in instants],
    }
    with open(os.path.join(HERE, "top", name + ".json"), "w") as file:
        file.write(json.dumps(record, indent=0).replace("\n", " ").replace("{ \"t\"", "\n{ \"t\"") + "\n")
    print(name, mp.nstr(floor, 3))


def write():
    os.makedirs(os.path.join(HERE, "top"), exist_ok=True)
    I = (0.00185, 0.00185, 0.0008)
    leaning = (0.875, 0.375, 0.25, 0.1767766952966369)      # 60 degrees off or so
    half = (0.5, 0.5, 0.5, 0.5)                              # axis level
    case("looping", "started against its precession", I, leaning, (0.0, -2.0, 90.0), 10.0)
    case("cuspidal", "let go while spinning", I, leaning, (0.0, 0.0, 70.0), 10.0)
    case("wavy", "pushed on in its precession", I, leaning, (1.0, 3.0, 60.0), 10.0)
    case("level", "axis level, moderate spin", I, half, (3.0, -1.0, 40.0), 10.0)
    case("slow_spin", "a pendulum that turns", I, leaning, (1.0, -4.0, 3.0), 10.0)
    case("sleeping", "upright but for 1e-3, spin above the threshold", I, (1.0, 0.0005, 0.0, 0.0), (0.0, 0.001, 53.8), 10.0)
    case("sleeping_1e-6", "upright but for 1e-6", I, (1.0, 0.0, 5e-7, 0.0), (1e-6, 0.0, 60.0), 10.0)
    case("just_unstable", "upright but for 1e-3, spin 0.99 of the threshold", I, (1.0, 0.0005, 0.0, 0.0), (0.0, 0.001, 52.7), 10.0)
    case("just_unstable_1e-6", "upright but for 1e-6, spin 0.99 of the threshold", I, (1.0, 0.0, 5e-7, 0.0), (1e-6, 0.0, 52.7), 10.0)
    case("falling", "upright but for 1e-8, no spin", I, (1.0, 5e-9, 0.0, 0.0), (0.0, 0.0, 0.0001), 5.0)
    case("hanging", "below the pivot, small swings", I, (0.0005, 1.0, 0.0, 0.0003), (0.0, 0.01, 20.0), 10.0)
    case("hanging_below_1e-6", "the same by the sign of the arm, 1e-6 off", I, (1.0, 5e-7, 0.0, 0.0), (0.0, 1e-6, 20.0), 10.0, arm=(0.0, 0.0, -0.05))
    case("inverted_axis", "force on the other end of the axis", I, leaning, (1.0, -2.0, 70.0), 10.0, arm=(0.0, 0.0, -0.05))
    case("along_world_x", "gravity along world x", I, leaning, (1.0, -2.0, 70.0), 10.0, force=(4.905, 0.0, 0.0))
    case("along_world_oblique", "gravity along no axis", I, half, (1.0, -2.0, 70.0), 10.0, force=(1.0, -4.0, 2.5))
    case("upward", "a force up", I, leaning, (1.0, -2.0, 50.0), 10.0, force=(0.0, 0.0, 4.905))
    case("axis_1", "symmetric about the first axis", (0.0008, 0.00185, 0.00185), half, (70.0, 1.0, -2.0), 10.0, arm=(0.05, 0.0, 0.0))
    case("axis_2", "symmetric about the second axis, inverted", (0.00185, 0.0008, 0.00185), half, (-2.0, 70.0, 1.0), 10.0, arm=(0.0, -0.05, 0.0))
    case("backward_spin", "negative spin", I, leaning, (0.0, 2.0, -60.0), 10.0)
    case("spherical", "three equal moments", (0.002, 0.002, 0.002), leaning, (0.0, 2.0, 30.0), 10.0)
    case("disc", "I3 = 2 I1", (0.001, 0.001, 0.002), leaning, (0.0, 2.0, 30.0), 10.0)
    case("nearly_free", "a force of 1e-9 N", I, leaning, (3.0, 2.0, -10.0), 100.0, force=(0.0, 0.0, -1e-9))
    case("fast", "1e4 rad/s", I, leaning, (0.0, 0.0, 1e4), 10.0)
    case("upright_pushed", "through the upright position", I, (1.0, 0.0, 0.0, 0.0), (5.0, 0.0, 30.0), 10.0)
    case("upright_grazed", "through the upright position, 1e-9 beside it, hardly any spin", I, (1.0, 0.0, 5e-10, 0.0), (5.0, 0.0, 0.001), 5.0)
    case("bottom_pushed", "through the hanging position", I, (0.0, 1.0, 0.0, 0.0), (5.0, 1.0, 30.0), 10.0)
    case("top_to_bottom", "all the way round", I, (0.5, 0.5, 0.5, -0.5), (30.0, 0.001, 0.001), 10.0)
    case("long", "1e6 s", I, leaning, (0.0, -2.0, 90.0), 1e6)


def check():
    with open(os.path.join(HERE, "heavy_top_looping.json")) as file:
        r = json.load(file)
    load = r["torques"][0]
    force = [mp.mpf(load["mass"])*mp.mpf(g) for g in load["gravity_world"]]
    at = motion(exact(r["inertia"]), exact(r["omega0_body"]), unit(r["q0"]), force, exact(load["r_cm_body"]))
    print(mp.nstr(max(angle(exact(row["q"]), at(mp.mpf(row["t"]))[0]) for row in r["samples"]), 3))


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        check()
    else:
        write()
