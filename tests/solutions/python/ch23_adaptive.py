"""Chapter 23: Adaptive supersampling."""

from __future__ import annotations

import math
import statistics

from raybook.vec import Rgb


def needs_more(contrast: Rgb, error: float, samples: list[Rgb]) -> int:
    if len(samples) < 2:
        return 1
    for limit, channel in zip(contrast, zip(*samples)):
        low, high = min(channel), max(channel)
        if low + high > 0 and (high - low) / (high + low) > limit:
            return 1
    deviation = statistics.stdev(sample.luminance() for sample in samples)
    return int(deviation / math.sqrt(len(samples)) > error)


def spend_budget(deviations: list[float], least: int, budget: int) -> list[int]:
    """In proportion to σ, by halving the interval of the factor; then the largest remainders are rounded up."""
    low, high = 0.0, 1e9
    for _ in range(200):
        middle = 0.5 * (low + high)
        if sum(max(middle * d, least) for d in deviations) > budget:
            high = middle
        else:
            low = middle
    shares = [max(low * d, float(least)) for d in deviations]
    counts = [math.floor(share) for share in shares]
    order = sorted(range(len(shares)), key=lambda i: counts[i] - shares[i])
    left = budget - sum(counts)
    for i in range(left if order else 0):
        counts[order[i % len(order)]] += 1
    return counts
