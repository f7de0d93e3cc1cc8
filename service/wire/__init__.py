"""From a validated request to the domain's objects, and from its results to what is sent."""
