#pragma once

#include "family.hpp"

#include <quell/quell.hpp>

#include <algorithm>

namespace quell::bench {

/// The one template that generated files instantiate.
template <class P, class Storage, bool with_serial> class PresetWorkload final : public Workload {
    P pipeline;
    History<P, Storage> history;

public:
    PresetWorkload(P const& p, Extent size) : pipeline(p), history(size, p) {}
    void run(Input const& frame, How how) override { quell::run(pipeline, frame, history, Timed<Chosen<with_serial>>{{how}, &taken}); }
    [[nodiscard]] double bytes_per_pixel() const override { return history.bytes_per_pixel(); }
};

/// The names under which passes are reported: no spaces, and several of one name numbered.
template <class P> std::vector<std::string> pass_names(P const& pipeline) {
    std::vector<std::string> names{pipeline.ingest.name};
    pipeline.for_each_pass([&](auto const& pass) { names.push_back(pass.name); });
    if (names.size() == 1) names.push_back(detail::PassThrough::name);
    auto const all = names;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::ranges::replace(names[i], ' ', '-');
        if (std::ranges::count(all, all[i]) > 1)
            names[i] += "/level" + std::to_string(std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i), all[i]));
    }
    return names;
}

/// @tparam make_pipeline a preset as a constant expression's type: a captureless function object
template <class Storage, auto make_pipeline> Family make_family(std::string preset) {
    using P = decltype(make_pipeline());
    using Format = typename Storage::format;
    // One pixel at a time is the reference for the fast storage only; elsewhere it would double the time to compile for nothing.
    constexpr bool with_serial = std::is_same_v<Storage, Planar<>>;
    return {std::move(preset),
            std::string(Storage::name) + "-" + Format::name,
            sizeof(typename Format::Element),
            with_serial,
            pass_names(make_pipeline()),
            [](Extent size) -> std::unique_ptr<Workload> {
                return std::make_unique<PresetWorkload<P, Storage, with_serial>>(make_pipeline(), size);
            }};
}

} // namespace quell::bench
