"""Many queries: the same answers as one by one, whatever the number of threads."""

import signal
import threading
import time

import numpy as np
import pytest

import taut


@pytest.fixture(scope="module")
def finder(maze):
    return taut.Polyanya(taut.FreeSpace(maze))


def queries(n, seed=1, low=0.5, high=45.5):
    return np.random.default_rng(seed).uniform(low, high, (n, 4))


def test_answers_are_those_of_single_queries(finder):
    asked = queries(300)
    answers = finder.find_many(asked, paths=True)
    assert len(answers) == 300 and (answers.status == 0).all()
    for i, (sx, sy, gx, gy) in enumerate(asked):
        path = finder.find((sx, sy), (gx, gy))
        assert answers.length[i] == path.length
        np.testing.assert_array_equal(answers.path(i), path.points)


def test_threads_change_nothing(finder):
    asked = queries(2000)
    one, three = (finder.find_many(asked, paths=True, threads=n) for n in (1, 3))
    np.testing.assert_array_equal(one.length, three.length)
    np.testing.assert_array_equal(one.points, three.points)
    np.testing.assert_array_equal(one.offsets, three.offsets)


def test_landmarks_change_no_length(finder):
    asked = queries(500, seed=2)
    faster = taut.Polyanya(finder.space, landmarks=8)
    np.testing.assert_array_equal(finder.find_many(asked).length, faster.find_many(asked).length)


def test_what_has_no_path_says_why(sealed):
    finder = taut.Polyanya(taut.FreeSpace(sealed))
    answers = finder.find_many([[1, 1, 1, 3], [1, 1, 3, 1], [9, 9, 1, 1]], paths=True)
    assert answers.status.tolist() == [0, 1, 2]
    assert answers.length[0] == 2 and np.isinf(answers.length[1]) and np.isnan(answers.length[2])
    assert [len(answers.path(i)) for i in range(3)] == [2, 0, 0]
    with pytest.raises(IndexError):
        answers.path(3)


def test_no_queries_have_no_answers(finder):
    assert len(finder.find_many([])) == 0 and len(finder.find_many(np.empty((0, 4)))) == 0
    with pytest.raises(IndexError, match="paths=True"):
        finder.find_many([[1, 1, 2, 2]]).path(0)


@pytest.mark.parametrize("asked", [np.zeros((3, 5)), np.zeros(3), "1 1 2 2", [[1, 2, 3]], [[1, 1, 2, "x"]]])
def test_queries_of_another_shape_are_refused(finder, asked):
    with pytest.raises(ValueError, match="queries"):
        finder.find_many(asked)


def test_other_kinds_of_arrays_are_taken(finder):
    asked = np.array([[1, 1, 40, 40], [2, 2, 30, 3]])
    expected = finder.find_many(asked).length
    others = asked.astype(np.float32), np.asfortranarray(asked, dtype=float), asked.tolist(), asked.reshape(2, 2, 2)
    for other in others:
        np.testing.assert_array_equal(finder.find_many(other).length, expected)
    np.testing.assert_array_equal(finder.find_many(np.repeat(asked, 2, axis=0).astype(float)[::2]).length, expected)


def test_goals_in_one_search(finder):
    goals = [(40.5, 40.5), (3, 3), (-5, 0)]
    each = finder.find_each((1, 1), goals)
    assert each[2] is None
    assert [p.length for p in each[:2]] == [finder.find((1, 1), g).length for g in goals[:2]]
    path, which = finder.find_nearest((1, 1), goals)
    assert which == 1 and path.exact_length == each[1].exact_length
    with pytest.raises(taut.InputError):
        finder.find_each((-1, -1), goals)


def test_python_threads_share_a_finder_and_run_beside_it(finder):
    asked = queries(400)
    expected = finder.find_many(asked).length
    found = [np.full(len(asked), np.nan) for _ in range(4)]

    def ask(lengths):
        for i, (sx, sy, gx, gy) in enumerate(asked):
            lengths[i] = finder.find((sx, sy), (gx, gy)).length

    threads = [threading.Thread(target=ask, args=(lengths,)) for lengths in found]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for lengths in found:
        np.testing.assert_array_equal(lengths, expected)


def test_the_lock_is_free_while_it_works(finder):
    ticks = []
    done = threading.Event()

    def tick():
        while not done.wait(0.001):
            ticks.append(1)

    other = threading.Thread(target=tick)
    other.start()
    finder.find_many(queries(20000))
    done.set()
    other.join()
    assert len(ticks) > 3


@pytest.mark.parametrize("threads", [1, 2])
def test_an_interrupt_ends_it(finder, threads):
    asked = np.tile(queries(10000), (100, 1))  # some seconds
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    begin = time.process_time()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        finder.find_many(asked, threads=threads)
    timer.join()
    assert time.process_time() - begin < 2.5


def test_a_query_from_python_costs_little_more_than_one_from_cpp(finder):
    asked = queries(5000, seed=4)
    pairs = [((sx, sy), (gx, gy)) for sx, sy, gx, gy in asked.tolist()]

    def cpu(work):
        begin = time.process_time()
        work()
        return (time.process_time() - begin) / len(asked)

    from_python = min(cpu(lambda: [finder.find(*pair).length for pair in pairs]) for _ in range(5))
    from_cpp = min(cpu(lambda: finder.find_many(asked, threads=1)) for _ in range(5))
    # About 2 us; the rest is for machines that are busy, and for builds that are not optimised.
    assert from_python - from_cpp < max(10e-6, from_cpp / 2)
