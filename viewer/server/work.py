"""What a worker process does: it holds the bodies, and answers one request after the other."""

import pickle
import signal
import threading
import traceback
from collections.abc import Callable
from dataclasses import replace
from multiprocessing.connection import Connection
from typing import TYPE_CHECKING, Any, NamedTuple

from bodymeasure.errors import BodymeasureError, MissingUnitError

if TYPE_CHECKING:
    from bodymeasure.viewer.content.bodies import Bodies
    from bodymeasure.viewer.content.requests import Request
    from bodymeasure.viewer.content.shown import ShownBody

    from bodymeasure.chart import Definitions


class Job(NamedTuple):
    """A request for a worker, with the bodies that it does not know yet.

    Parameters
    ----------
    number : int
    request : Request or None
        None asks for nothing but to be ready for requests.
    put : tuple of ShownBody
        Bodies that are new, or that have changed.
    ids : tuple of str
        The bodies that are still open.
    own : Definitions, optional
        The set of definitions that the user has given.
    """

    number: int
    request: "Request | None"
    put: "tuple[ShownBody, ...]"
    ids: tuple[str, ...]
    own: "Definitions | None" = None


class Done(NamedTuple):
    """The answer to a job.

    Parameters
    ----------
    number : int
    kind : str
        json, binary, file, body (a pickled `ShownBody`), error (a sentence for the user) or
        failure (a traceback for the log).
    content : bytes
    name : str
        What a file is to be called.
    wants : str
        Of an error, what the user may know that is lacking: the unit.
    """

    number: int
    kind: str
    content: bytes
    name: str = ""
    wants: str = ""


class Progressed(NamedTuple):
    """How far a job is."""

    number: int
    done: int
    total: int
    words: str


def work(connection: Connection) -> None:
    """Answer the jobs that come through a connection, until it or the parent ends."""
    # Ctrl-C reaches the whole process group; the parent alone decides what it means.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # Slow imports, which the parent does not need.
    from bodymeasure.oracle.workers import end_with_parent

    threading.Thread(target=end_with_parent, daemon=True).start()
    from bodymeasure.viewer.content.bodies import Bodies

    bodies = Bodies()
    while True:
        try:
            job: Job = connection.recv()
            connection.send(done(bodies, job, connection.send))
        except (EOFError, BrokenPipeError):
            return


def done(bodies: "Bodies", job: Job, tell: Callable[[Any], None]) -> Done:
    """Return the answer to a job; `tell` is called with how far it is."""
    from bodymeasure.viewer.content.answers import File, answer
    from bodymeasure.viewer.content.opening import opened, read_again
    from bodymeasure.viewer.content.requests import OpenFile, ReadAgain
    from msgspec import json

    def progress(so_far: int, total: int, words: str) -> None:
        tell(Progressed(job.number, so_far, total, words))

    bodies.own = job.own
    bodies.keep_only(dict.fromkeys(job.ids))
    for body in job.put:
        bodies.put(body)
    try:
        match job.request:
            case None:
                _warm(bodies)
                return Done(job.number, "json", b"{}")
            case OpenFile():
                return Done(job.number, "body", pickle.dumps(opened(job.request)))
            case ReadAgain():
                read = read_again(bodies[job.request.body])
                return Done(job.number, "body", pickle.dumps(read))
        content = answer(bodies, job.request, progress)
    except MissingUnitError as error:
        return Done(job.number, "error", str(error).encode(), wants="unit")
    except BodymeasureError as error:
        return Done(job.number, "error", str(error).encode())
    except Exception:
        return Done(job.number, "failure", traceback.format_exc().encode())
    if isinstance(content, File):
        return Done(job.number, "file", bytes(content), content.name)
    if isinstance(content, dict):
        return Done(job.number, "json", json.encode(content))
    return Done(job.number, "binary", content)


def _warm(bodies: "Bodies") -> None:
    """Make what the first tape over each body needs, so that nobody waits for it."""
    from bodymeasure.viewer.content.requests import MeasurePath
    from bodymeasure.viewer.content.tapes import path_answer

    for body in bodies.shown.values():
        ends = ((0, 0.25, 0.25), (0, 0.75, 0.75))
        path_answer(replace(body), MeasurePath(locations=ends))
