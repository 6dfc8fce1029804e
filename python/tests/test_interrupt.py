# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C, progress and threads."""
import os
import signal
import threading
import time

import numpy as np
import pytest

import loopmend


def test_ctrl_c_ends_a_fill_soon():
    scan = loopmend.sample()
    struck = []

    def strike():
        struck.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.5, strike)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        loopmend.fill(scan.vertices, scan.faces, density=4, flow="wf", mode="steps", steps=1000, sigma=1e-3)
    answered = time.process_time()
    timer.join()
    assert answered - struck[0] < 5  # of the processor's time: a few steps of the flow, not its thousand
    assert loopmend.fill(scan.vertices, scan.faces, loops=6).holes[5].is_filled  # the next call is as good as ever


def test_ctrl_c_keeps_what_is_finished_when_asked():
    """Struck when the first of five holes is done: that one is kept, as it is without Ctrl-C."""
    scan = loopmend.sample()
    told = []

    def strike(done, total, number):
        told.append(number)
        if len(told) == 1:
            signal.raise_signal(signal.SIGINT)

    slow = {"flow": "wf", "mode": "steps", "steps": 200, "sigma": 1e-2, "threads": 1}
    result = loopmend.fill(scan.vertices, scan.faces, keep_partial=True, progress=strike, **slow)
    assert result.stopped
    kept = [hole.number for hole in result.holes if hole.is_filled]
    assert told[0] in kept and len(kept) < 5
    alone = loopmend.fill(scan.vertices, scan.faces, loops=kept, **slow)
    assert alone.vertices.tobytes() == result.vertices.tobytes() and alone.faces.tobytes() == result.faces.tobytes()
    open_ones = [hole.message for hole in result.holes if not hole.is_filled and hole.kind == "hole"]
    assert set(open_ones) == {"not finished when stopped"}


def test_a_second_ctrl_c_is_raised():
    scan = loopmend.sample()
    struck = 0

    def handler(number, frame):
        nonlocal struck
        if struck == 1:
            signal.setitimer(signal.ITIMER_REAL, 0)
        struck += 1  # no call follows: Python lets the next strike in at calls, and it would hide this one
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            signal.setitimer(signal.ITIMER_REAL, 0.3, 0.0001)  # again before the work has ended
            loopmend.fill(scan.vertices, scan.faces, density=4, flow="wf", mode="steps", steps=1000, sigma=1e-3,
                          keep_partial=True)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert struck == 2


def test_what_a_callback_raises_stops_the_work_also_when_ctrl_c_would_not(two_holes):
    def stop(done, total, number):
        raise ValueError("enough")

    with pytest.raises(ValueError, match="enough"):
        loopmend.fill(*two_holes, keep_partial=True, progress=stop)


def test_a_handler_may_raise_what_it_likes():
    class Alarm(Exception):
        pass

    def handler(number, frame):
        raise Alarm

    scan = loopmend.sample()
    before = signal.signal(signal.SIGALRM, handler)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        with pytest.raises(Alarm):
            loopmend.fill(scan.vertices, scan.faces, density=4, flow="wf", mode="steps", steps=1000, sigma=1e-3)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_progress_is_told_on_the_calling_thread(two_holes):
    told = []
    loopmend.fill(*two_holes, progress=lambda *words: told.append((threading.get_ident(), *words)))
    assert {thread for thread, *_ in told} == {threading.get_ident()}
    assert [done for _, done, _, _ in told] == [1, 2]
    assert {total for _, _, total, _ in told} == {2}
    assert {number for *_, number in told} == {1, 2}


def test_what_the_callback_raises_stops_the_work():
    class Enough(Exception):
        pass

    def stop(done, total, number):
        raise Enough(f"{done} of {total}")

    scan = loopmend.sample()
    with pytest.raises(Enough, match="1 of 5"):
        loopmend.fill(scan.vertices, scan.faces, threads=1, progress=stop)


def test_other_threads_run_meanwhile():
    """Python code of this thread's siblings goes on: the GIL is released."""
    scan = loopmend.sample()
    ticks, ended = [0], threading.Event()

    def tick():
        while not ended.is_set():
            ticks[0] += 1
            time.sleep(0.001)

    ticking = threading.Thread(target=tick)
    ticking.start()
    before = ticks[0]
    loopmend.fill(scan.vertices, scan.faces)
    meanwhile = ticks[0] - before
    ended.set()
    ticking.join()
    assert meanwhile > 10  # hundreds on an idle machine, none or one where the GIL is held


def test_fills_on_several_threads_give_the_same_bits(sphere, two_holes):
    wanted = [loopmend.fill(*mesh).vertices.tobytes() for mesh in (sphere, two_holes)]
    got = {}

    def work(k):
        got[k] = loopmend.fill(*(sphere, two_holes)[k % 2]).vertices.tobytes()

    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [got[k] for k in range(4)] == wanted * 2
    assert np.array_equal(sorted(got), range(4))
