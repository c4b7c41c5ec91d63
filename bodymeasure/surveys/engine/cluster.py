"""The survey on a cluster: Dask's workers on this machine or on others."""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from importlib.util import find_spec
from typing import Any, Protocol

from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.measure import package_versions
from bodymeasure.oracle.workers import WorkerError
from bodymeasure.surveys.engine.batches import Answer, Batch, Work

# Batches that are sent ahead for each thread of a worker, so that none waits for the next.
AHEAD = 2
# How long a scheduler may take to answer, in seconds.
TIMEOUT = 20.0
LOST = (
    "the connection to the scheduler is lost; the same call goes on with what is not yet done when "
    "the scheduler is there again"
)


class Client(Protocol):
    """What a survey asks of a client of Dask's: a `distributed.Client`."""

    def submit(self, func: Any, *args: Any, **kwargs: Any) -> Any:
        """Send a call to a worker."""
        ...

    def run(self, function: Any, *args: Any, **kwargs: Any) -> Any:
        """Call a function on every worker."""
        ...

    def run_on_scheduler(self, function: Any, *args: Any, **kwargs: Any) -> Any:
        """Call a function on the scheduler."""
        ...

    def nthreads(self) -> Mapping[str, int]:
        """Return the number of threads of each worker."""
        ...


def require_distributed() -> None:
    """Raise a MissingExtraError if there is no Dask."""
    if find_spec("distributed") is None:
        raise MissingExtraError("a survey on a cluster", "distributed", "cluster")


class Cluster:
    """Measures on the workers of a client's scheduler.

    Dask sends a batch to another worker when one dies, and gives up a batch with which several have
    died; its bodies are tried one by one then.

    Parameters
    ----------
    client : Client
    """

    def __init__(self, client: Client) -> None:
        self._client = client

    def __call__(self, batches: Iterator[Batch], work: Work) -> Iterator[Answer]:
        """Yield the rows of each batch, in the order in which they are done.

        Raises
        ------
        InputError
            If there is no worker, or one has other versions of packages than this process.
        """
        import distributed

        dask: Any = distributed
        self._require_same_versions()
        sent: dict[Any, Batch] = {}

        def send(some: Iterable[Batch]) -> list[Any]:
            futures = []
            for batch in some:
                # Not pure: Dask must not answer from what another survey has asked.
                future = self._client.submit(work.rows, batch.bodies, pure=False)
                sent[future] = batch
                futures.append(future)
            return futures

        def ahead() -> Iterator[Batch]:
            while len(sent) < AHEAD * max(sum(self._client.nthreads().values()), 1):
                batch = next(batches, None)
                if batch is None:
                    return
                yield batch

        try:
            done = dask.as_completed(send(ahead()), loop=getattr(self._client, "loop", None))
            for future in done:
                if future.status == "lost":
                    # The worker that held the rows has died, and they are measured again.
                    done.add(future)
                    continue
                batch = sent.pop(future)
                if future.status == "cancelled":
                    raise WorkerError(LOST)
                error = future.exception() if future.status == "error" else None
                if not isinstance(error, dask.KilledWorker):
                    rows = future.result()
                    done.update(send(ahead()))
                    yield Answer(batch, rows)
                elif len(batch.bodies) > 1:
                    done.update(send(batch.apart()))
                else:
                    yield Answer(batch, batch.given_up())
                future.release()
        finally:
            for future in sent:
                future.cancel()

    def _require_same_versions(self) -> None:
        mine = package_versions()
        try:
            self._client.run_on_scheduler(package_versions)
            found: dict[str, dict[str, str]] = self._client.run(package_versions)
        except Exception as error:
            # Whatever Dask makes of a module that is not there.
            raise InputError(
                f"the scheduler or a worker cannot load bodymeasure ({error}); start all of them "
                "in environments with the bodymeasure of this process"
            ) from None
        if not found:
            raise InputError(
                "the scheduler has no worker; start some with `dask worker SCHEDULER --nthreads 1 "
                "--nworkers N`, in an environment with bodymeasure"
            )
        for worker, versions in found.items():
            for package, version in versions.items():
                if version != mine[package]:
                    raise InputError(
                        f"the worker {worker} has {package} {version}, and this process "
                        f"{mine[package]}; with different versions, numbers may differ: install "
                        "the same everywhere"
                    )


@contextmanager
def connected(address: str) -> Iterator[Client]:
    """Connect to the scheduler at an address, such as ``tcp://host:8786``.

    Raises
    ------
    InputError
        If it is no address, or none answers.
    MissingExtraError
        If there is no Dask.
    """
    require_distributed()
    import distributed
    from distributed import comm

    dask: Any = distributed
    comms: Any = comm
    try:
        # A client that such an address ends complains again, at length, when Python ends.
        comms.get_address_host_port(address)
    except ValueError as error:
        raise InputError(
            f"{address!r} is no address of a scheduler ({error}); expected what `dask scheduler` "
            "prints, such as tcp://host:8786"
        ) from None
    try:
        client = dask.Client(address, timeout=TIMEOUT, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise InputError(
            f"{address}: no scheduler answers there ({error}); start one with `dask scheduler`, "
            "and give the address that it prints, such as tcp://host:8786"
        ) from None
    try:
        yield client
    finally:
        client.close()
