"""Sweeps on workers of Dask have the bits of one process."""

import dask
import numpy
from dask.distributed import Client, LocalCluster

from conftest import ROOT

import meniscus


def test_two_workers_give_the_same_bits():
    document = meniscus.open(ROOT / "simulations" / "utube.md")
    arguments = {"over": {"b": "0..400", "h_l": "2..4"}, "keep": "maximum(y) from 2 [s], y at end", "halton": 64}
    whole = document.sweep(**arguments)
    sweep = dask.delayed(document.sweep)
    parts = [sweep(**arguments, shard=(number, 8)) for number in range(1, 9)]
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster):
        tables = dask.compute(*parts)
    for name in whole.columns:
        assert numpy.concatenate([table[name] for table in tables]).tobytes() == whole[name].tobytes()
