// Chapter 23: Adaptive supersampling.

#include "raybook/ch23_adaptive.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace ch23_adaptive {

// Whether the channel of this limit has too much contrast.
static bool contrasts(const std::vector<Rgb>& samples, double Rgb::*channel, double limit) {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const Rgb& sample : samples) {
        low = std::min(low, sample.*channel);
        high = std::max(high, sample.*channel);
    }
    return low + high > 0 && (high - low) / (high + low) > limit;
}

unsigned needs_more(const Rgb& contrast, double error, const std::vector<Rgb>& samples) {
    const auto n = static_cast<double>(samples.size());
    if (n < 2 || contrasts(samples, &Rgb::r, contrast.r) || contrasts(samples, &Rgb::g, contrast.g)
        || contrasts(samples, &Rgb::b, contrast.b)) {
        return 1;
    }
    // Mean and squares in one pass (Welford 1962).
    double mean = 0, squares = 0, count = 0;
    for (const Rgb& sample : samples) {
        const double y = luminance(sample), before = y - mean;
        count++;
        mean += before / count;
        squares += before * (y - mean);
    }
    return std::sqrt(squares / (n - 1) / n) > error;
}

// One sample after the other, where it lowers the sum of σ²/n most.
std::vector<unsigned> spend_budget(const std::vector<double>& deviations, unsigned least, unsigned budget) {
    std::vector<unsigned> counts(deviations.size(), least);
    const auto gain = [&](unsigned i) {
        const double n = counts[i];
        return deviations[i] * deviations[i] / (n * (n + 1));
    };
    std::priority_queue<std::pair<double, unsigned>> best;
    for (unsigned i = 0; i < counts.size(); i++) {
        best.push({gain(i), i});
    }
    for (auto left = static_cast<std::size_t>(budget) - least * counts.size(); left > 0 && !best.empty(); left--) {
        const unsigned i = best.top().second;
        best.pop();
        counts[i]++;
        best.push({gain(i), i});
    }
    return counts;
}

}
