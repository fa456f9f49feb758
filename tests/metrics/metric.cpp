#include "pictures.hpp"

#include <quell/metrics/metric.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <set>
#include <string_view>

using namespace quell;
using namespace quell::metrics;

TEST_CASE("the table's metrics are what their functions say, of a picture and inside a mask") {
    auto const reference = pictures::noise({9, 6}, 1), test = pictures::noise({9, 6}, 2);
    Mask mask(reference.pixels.size());
    mask[7] = mask[30] = 1;
    Comparison const compared{reference, test};
    for (auto const& where : {Mask{}, mask}) {
        auto const errors = errors_of(compared, where);
        CHECK(errors["rmse"] == rmse(reference, test, where));
        CHECK(errors["ssim"] == ssim(reference, test, where));
        CHECK(errors["flip"] == flip(reference, test).mean(where));
    }
    std::set<std::string_view> names;
    errors_of(compared).for_each([&](Metric const& metric, double) { CHECK(names.insert(metric.name).second); });
    CHECK(names.size() == all_metrics.size());
}

TEST_CASE("means of errors are of those that were added, and unknown without any") {
    MeanErrors mean;
    CHECK(std::isnan(mean.mean()["flip"]));
    mean.add({{0.25, 0.5, 1.}});
    mean.add({{0.75, 1., 0.}});
    CHECK(mean.mean().values == std::array{0.5, 0.75, 0.5});
}
