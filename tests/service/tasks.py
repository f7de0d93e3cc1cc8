"""What worker processes are given to do in tests; imports next to nothing, for each of them imports it."""

import os
import sys
import time

from kinematics.errors import Fault, FormSizeError
from service.work.allotted_time import each_in_time


def double(value: int) -> int:
    return 2 * value


def endless() -> None:
    while True:
        pass


def asleep(seconds: float) -> float:
    time.sleep(seconds)
    return seconds


def until_there(path: str) -> None:
    """Wait for a file."""
    while not os.path.exists(path):
        time.sleep(0.005)


def noted(path: str, text: str) -> str:
    with open(path, "a") as file:
        file.write(text)
    time.sleep(0.3)
    return text


def pid() -> int:
    return os.getpid()


def greedy() -> int:
    return len(bytearray(3 * 1024**3))


def crash() -> None:
    os.abort()


def refuse() -> None:
    raise FormSizeError(Fault(code="form_too_large", where=("rows", 1), params={"limit": 3}))


def imported(name: str) -> bool:
    return name in sys.modules


def doubled_in_time(numbers: list[int], seconds: float) -> list[int]:
    """Double numbers, as many as processor time allows; a negative one takes for ever."""

    def double_or_stay(number: int) -> int:
        while number < 0:
            pass
        return 2 * number

    return each_in_time(double_or_stay, numbers, seconds)


def doubled_whatever_is_caught(numbers: list[int], seconds: float, goes_on: bool) -> list[int]:
    """Double numbers; a negative one takes long, in code that catches what it can, as libraries do.

    NumPy's norm, for one, turns whatever is raised while it reads `axis` into a `TypeError`.
    """

    def double_or_catch(number: int) -> int:
        try:
            while number < 0:
                pass
        except Exception as error:
            raise TypeError("axis") from error
        except BaseException:
            if goes_on:
                return 0
            raise ValueError("caught") from None
        return 2 * number

    return each_in_time(double_or_catch, numbers, seconds)


def refused_in_time(numbers: list[int], seconds: float) -> list[int]:
    """Refuse the second number, in good time."""

    def double_or_refuse(number: int) -> int:
        if number == 2:
            refuse()
        return 2 * number

    return each_in_time(double_or_refuse, numbers, seconds)
