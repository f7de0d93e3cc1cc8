"""Whom an address is counted for."""

import functools
from ipaddress import IPv6Address, IPv6Network

_SUBNET = 64
"""Bits of an IPv6 address that an access provider gives to one customer, at the most (RFC 6177, RIPE-690)."""


@functools.lru_cache(4096)
def caller_at(host: str) -> str:
    """Return what stands for the caller at an address: of IPv6 the subnet, all of whose addresses are theirs.

    An IPv4 address that is written as IPv6 is that address.
    """
    if ":" not in host:
        return host
    try:
        address = IPv6Address(host)
    except ValueError:  # what a proxy says need not be an address
        return host
    if address.ipv4_mapped is not None:
        return str(address.ipv4_mapped)
    return str(IPv6Network((int(address), _SUBNET), strict=False))
