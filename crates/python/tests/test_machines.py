"""Sweeps on workers of Dask and of Ray have the bits of one process. What distributing a batch costs is printed."""

import time

import dask
import numpy
import ray
from dask.distributed import Client, LocalCluster

from conftest import ROOT

import meniscus

SWEEP = {"over": {"b": "0..400", "h_l": "2..4"}, "keep": "maximum(y) from 2 [s], y at end", "halton": 64}
SHARDS = [(number, 8) for number in range(1, 9)]


def tube():
    return meniscus.open(ROOT / "simulations" / "utube.md")


def compare(name, compute):
    """`compute` gives the tables of the shards; the first time the workers open the document."""
    document = tube()
    compute()
    times = []
    for _ in range(5):
        begun = time.perf_counter()
        tables = compute()
        times.append(time.perf_counter() - begun)
    whole = document.sweep(**SWEEP)
    for column in whole.columns:
        assert numpy.concatenate([table[column] for table in tables]).tobytes() == whole[column].tobytes()
    begun = time.perf_counter()
    for shard in SHARDS:
        document.sweep(**SWEEP, shard=shard)
    alone = time.perf_counter() - begun
    print(f"{name}: a batch of {len(SHARDS)} shards {1e3 * min(times):.1f} ms, in one process {1e3 * alone:.1f} ms")


def test_two_workers_of_dask_give_the_same_bits():
    sweep = dask.delayed(tube().sweep)
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster):
        # Impure, so that each batch is computed.
        compare("Dask", lambda: dask.compute(*[sweep(**SWEEP, shard=shard, pure=False) for shard in SHARDS]))


def test_two_workers_of_ray_give_the_same_bits():
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        document = ray.put(tube())
        sweep = ray.remote(lambda document, shard: document.sweep(**SWEEP, shard=shard))
        compare("Ray", lambda: ray.get([sweep.remote(document, shard) for shard in SHARDS]))
    finally:
        ray.shutdown()
