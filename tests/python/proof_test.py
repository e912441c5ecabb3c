import json

import numpy as np
import pytest

import taut


def test_the_shortest_path_has_a_certificate_that_the_judge_accepts(room):
    space = taut.FreeSpace(room)
    said = taut.judge(space, taut.certificate(space))
    assert said and said.proven and said.kind == "shortest"
    assert said.bound == pytest.approx(taut.shortest_path(room).length, abs=1e-9)
    assert "no path is shorter than 4.472135955" in said.words


def test_so_has_that_there_is_none(sealed):
    space = taut.FreeSpace(sealed)
    said = taut.judge(space, taut.certificate(space))
    assert said and said.kind == "none"


def test_so_has_the_widest_disc(room):
    space = taut.FreeSpace(room)
    said = taut.judge(space, taut.certificate(space, widest=True))
    assert said and said.kind == "widest"
    assert said.bound == 0.5  # between the wall's end and the limit of the world
    assert said.length == pytest.approx(said.bound, rel=1e-6)


def test_so_have_a_discs_arcs(room):
    space = taut.FreeSpace(room)
    proof = taut.certificate(space, radius=0.25)
    said = taut.judge(space, proof)
    assert said and said.kind == "arcs"
    length = taut.disc_path(space, 0.25).length
    assert said.bound <= length <= said.length < said.bound * 1.001
    smaller = json.loads(proof)
    smaller["radius"] = 0.125
    assert not taut.judge(space, json.dumps(smaller))


def test_what_was_tampered_with_is_not_proven(room):
    space = taut.FreeSpace(room)
    proof = json.loads(taut.certificate(space))
    proof["path"][1][1] -= 1
    said = taut.judge(space, json.dumps(proof))
    assert not said and not said.proven
    with pytest.raises(taut.InputError):
        taut.judge(space, "no certificate")
    with pytest.raises(ValueError):
        taut.certificate(taut.FreeSpace(room, taut.Footprint.disc(0.1)))


def test_an_audit_names_the_first_contact(room):
    audit = taut.audit(room, [(1, 1), (3, 1)])
    assert not audit and audit.leg == 0 and audit.at == (2, 1) and audit.gap is None
    assert audit.wall.startswith("the wall from (2, 0) to (2, 3)")
    disc = taut.audit(room, [(1, 1), (3, 1)], taut.Footprint.disc(0.25))
    assert disc.at == pytest.approx((1.75, 1)) and disc.on == pytest.approx((2, 1))


def test_an_audit_measures_what_is_valid(room):
    audit = taut.audit(room, np.array([(1, 1), (1, 3.5), (3, 3.5), (3, 1)]))
    assert audit and audit.reason == "" and audit.wall is None
    assert audit.length == 7 and audit.clearance == 0.5
    assert audit.gap == pytest.approx(7 - taut.shortest_path(room).length)
    assert taut.audit(room, [(1, 1), (1, 3.5)], gap=False).shortest is None
    with pytest.raises(taut.InputError):
        taut.audit(room, [(1, np.nan)])


def test_robots_collide_where_they_are_nearer_than_their_radii():
    a = np.array([[0, 0, 0], [10, 10, 0]])
    b = np.array([[0, 10, 0], [10, 0, 0]])
    (collision,) = taut.collisions([a, b], 0.5)
    assert collision.robots == (0, 1) and collision.times == pytest.approx((4.5, 5.5))
    assert collision.at == (pytest.approx((4.5, 0)), pytest.approx((5.5, 0)))
    assert taut.collisions([a, b + [0, 0, 1]], 0.5) == []
    assert len(taut.collisions([a, b + [0, 0, 1]], [0.5, 0.6])) == 1
    with pytest.raises(taut.InputError):
        taut.collisions([a[::-1]], 0.5)
