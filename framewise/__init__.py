"""Framewise from Python: a client of the service, and the grader without one.

from framewise import Client
with Client("http://127.0.0.1:8000") as client:
    print(client.exercise("puma560")["title"])

from framewise import check
check(table, "puma560").score
"""

from framewise.checking import Checked, check
from framewise.client import AsyncClient, Client, ProblemError

__all__ = ["AsyncClient", "Checked", "Client", "ProblemError", "check"]
