#include "pictures.hpp"

#include <quell/metrics/stability.hpp>

using namespace pictures;
using namespace quell::metrics;

TEST_CASE("flicker: known for an alternating signal") {
    Extent const size{6, 4};
    auto const reference = constant(size, glm::vec3(0.5f));
    Flicker sequence;
    for (int frame = 0; frame < 10; ++frame) sequence.add(reference, constant(size, glm::vec3(frame % 2 == 0 ? 0.375f : 0.625f)));
    CHECK(sequence.frames == 10);
    CHECK(sequence.mean() == doctest::Approx(0.125));
}

TEST_CASE("flicker: one flickering component of three") {
    auto const reference = constant({3, 3}, glm::vec3(0.5f));
    std::vector<Picture> const references(4, reference);
    std::vector<Picture> outputs;
    for (int frame = 0; frame < 4; ++frame) outputs.push_back(constant({3, 3}, {0.5f, 0.5f, frame < 2 ? 0.25f : 0.75f}));
    CHECK(flicker(references, outputs) == doctest::Approx(0.25 / std::sqrt(3.)));
}

TEST_CASE("flicker: agrees with the deviation computed in two passes") {
    Extent const size{5, 4};
    std::vector<Picture> references, outputs;
    for (unsigned frame = 0; frame < 30; ++frame) {
        references.push_back(noise(size, frame));
        outputs.push_back(noise(size, frame + 100));
    }
    double sum = 0.;
    for (std::size_t i = 0; i < 20; ++i) {
        glm::dvec3 mean(0.), variance(0.);
        for (std::size_t f = 0; f < 30; ++f) mean += glm::dvec3(outputs[f].pixels[i]) - glm::dvec3(references[f].pixels[i]);
        mean /= 30.;
        for (std::size_t f = 0; f < 30; ++f) {
            auto const d = glm::dvec3(outputs[f].pixels[i]) - glm::dvec3(references[f].pixels[i]) - mean;
            variance += d * d / 30.;
        }
        sum += std::sqrt((variance.x + variance.y + variance.z) / 3.);
    }
    CHECK(flicker(references, outputs) == doctest::Approx(sum / 20.).epsilon(1e-12));
}

TEST_CASE("flicker: what the reference does too, and a constant error, are none") {
    Extent const size{6, 4};
    Flicker sequence;
    for (unsigned frame = 0; frame < 8; ++frame) {
        auto reference = noise(size, frame), output = reference;
        for (auto& p : reference.pixels) p *= 0.5f;
        output = reference;
        for (auto& p : output.pixels) p += glm::vec3(0.25f);
        sequence.add(reference, output);
    }
    CHECK(sequence.mean() < 1e-7);
}

TEST_CASE("flicker: only what the mask selects counts") {
    Extent const size{8, 4};
    auto const reference = constant(size, glm::vec3(0.5f)), brighter = halves(constant(size, glm::vec3(1.f)), reference);
    std::vector<Picture> const references(2, reference), outputs{reference, brighter};
    CHECK(flicker(references, outputs, left_half(size)) == doctest::Approx(0.25));
    CHECK(flicker(references, outputs) == doctest::Approx(0.125));
}

TEST_CASE("flicker: refuses broken input") {
    auto const a = noise({4, 3}, 1), b = noise({5, 3}, 1);
    refuses_broken_input([](auto const& reference, auto const& output, auto const& mask) {
        return flicker(std::vector{reference, reference}, std::vector{output, output}, mask);
    });
    CHECK(refuses([&] { (void)flicker(std::vector{a, b}, std::vector{a, b}); }, {"frame 1", "5x3", "4x3"}));
    CHECK(refuses([&] { (void)flicker(std::vector{a, a}, std::vector{a}); }, {"1 outputs", "2 references"}));
    CHECK(refuses([&] { (void)flicker(std::vector{a}, std::vector{a}); }, {"1 frames", "at least 2"}));
    CHECK(refuses([] { (void)Flicker{}.mean(); }, {"0 frames", "at least 2"}));
}

TEST_CASE("lag: of an error that decays by half each frame") {
    std::vector<double> errors(5, 0.01);
    for (double e = 0.64; errors.size() < 40; e /= 2.) errors.push_back(0.01 + e);
    CHECK(settled_error(errors, 5) == doctest::Approx(0.01).epsilon(1e-4));
    CHECK(lag(errors, 5) == 7u); // 0.64 / 2^7 = 0.005
    CHECK(lag(errors, 5, 0.02) == 5u);
    CHECK(lag(errors, 5, 0.001) == std::nullopt);
}

TEST_CASE("lag: none without a rise, counted through a slow rise, and an outlier doesn't settle it") {
    CHECK(lag(std::vector{0.1, 0.11, 0.1, 0.12}, 1) == 0u);
    CHECK(lag(std::vector{0.1}, 0) == 0u);
    CHECK(lag(std::vector{0., 0., 0., 0.}, 0) == 0u);
    CHECK(lag(std::vector{0.1, 0.1, 0.5, 0.9, 0.4, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1}, 0) == 5u);
    CHECK(settled_error(std::vector{9., 9., 9., 9., 9., 9., 9., 9., 9., 0.1, 5., 0.1}, 0) == 0.1);
    CHECK(lag(std::vector{0.1, 0.2, 0.3, 0.4, 0.5, 0.9}, 0, 0.1) == std::nullopt);
    CHECK(lag(std::vector{0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.9}, 0) == std::nullopt);
}

TEST_CASE("lag: refuses broken input") {
    CHECK(refuses([] { (void)lag(std::vector{1., 2.}, 2); }, {"frame 2", "of 2"}));
    CHECK(refuses([] { (void)lag(std::vector{1., std::numeric_limits<double>::quiet_NaN()}, 0); }, {"frame 1", "nan"}));
}
