#include "known_limits.hpp"

#include <algorithm>
#include <ostream>

namespace quell::stability {
namespace {

/// Several methods of one case, for the same reason.
void add(std::vector<KnownLimit>& list, std::string const& subject, std::string const& metric, std::vector<std::string> const& methods,
         std::string const& reason) {
    for (auto const& method : methods) list.push_back({subject, method, metric, reason});
}

std::vector<KnownLimit> listed() {
    std::vector<KnownLimit> list;
    std::string const lag = "light that changes by itself leaves history that is followed rightly and is wrong; nothing but a clamp or the "
                            "host's gradients tells";
    add(list, "lightswitch", "first_frame_over_no_history", {"surface", "svgf"}, lag);
    add(list, "lightswitch", "worst_frame_over_fresh_start", {"surface", "surface-clamp", "svgf", "asvgf"}, lag);
    for (std::string const metric : {"first_frame_over_no_history", "worst_frame_over_fresh_start"})
        add(list, "cut-unnoticed", metric, {"surface", "svgf", "dual-color"},
            "depth and normals don't tell two rooms of one shape apart: call history.forget() at a cut");
    add(list, "cut-unnoticed", "worst_frame_over_fresh_start", {"general", "final-frame"},
        "what is left of the old room's light, where the two are nearly alike, is not told from noise");
    add(list, "thin-shadows", "contrast_over_reference", {"surface", "surface-clamp", "svgf", "general", "final-frame"},
        "a filter in space is wider than the shadow, and history along the surface smears it");
    add(list, "firefly", "frames_alive", {"surface", "svgf", "dual-color", "glossy", "dual-cone"},
        "no clamp: put SuppressFireflies{} before the stages");
    std::string const dark =
        "most samples of skewed noise are darker than its mean, and a clamp or a filter guided by brightness finds those";
    for (std::string const part : {"20", "5", "1"})
        add(list, "energy", "light_off_at_" + part + "_percent",
            {"surface-clamp", "mirror-clamp", "svgf", "asvgf", "dual-color", "glossy", "glossy-paper", "trmv", "trmv-paper"}, dark);
    for (std::string const part : {"5", "1"}) add(list, "energy", "light_off_at_" + part + "_percent", {"dual-cone"}, dark);
    add(list, "blur-linear", "worst_over_mean", {"blur", "blur-straight"},
        "where the spheres cross before what stands still three things meet, and two are told apart");
    return list;
}

} // namespace

std::vector<KnownLimit> const& known_limits() {
    static std::vector<KnownLimit> const all = listed();
    return all;
}

KnownLimit const* known_limit(Promise const& promise) {
    auto const found = std::ranges::find_if(known_limits(), [&](auto const& each) {
        return each.subject == promise.subject && each.method == promise.method && each.metric == promise.metric;
    });
    return found == known_limits().end() ? nullptr : &*found;
}

int judge(Results const& results, std::ostream& out) {
    int broken = 0;
    for (auto const& p : results.promises) {
        bool const known = known_limit(p) != nullptr;
        if (p.held() && !known) continue;
        if (!p.held() && !known) ++broken;
        out << (p.held() ? "holds, though a known limit: "
                : known  ? "known limit: "
                         : "broken: ")
            << p.subject << ' ' << p.method << ' ' << p.metric << ' ' << p.value << ", limit " << p.limit << '\n';
    }
    auto const held = std::ranges::count_if(results.promises, &Promise::held);
    out << held << " of " << results.promises.size() << " promises hold\n";
    return broken;
}

} // namespace quell::stability
