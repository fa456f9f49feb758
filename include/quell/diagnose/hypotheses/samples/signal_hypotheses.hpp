#pragma once

#include <quell/diagnose/hypotheses/samples/albedo_edges.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline std::string text_of(Exponent const& e) { return number(e.value) + " +- " + number(e.error); }

/// A signal that follows another albedo than the one given with it.
struct OtherAlbedo {
    Pairing pairing;
    Mistake mistake;
    char const *which, *remedy;
};
inline constexpr OtherAlbedo other_albedos[] = {
    {Pairing::turned, Mistake::signal_upside_down, "its rows in the other order",
     "give the signal and the guides in the same order of rows, the first at the top"},
    {Pairing::behind, Mistake::signal_behind, "the last frame's albedo",
     "give run() the signal and the guides of one frame: look at double buffers and at what is read back late"},
    {Pairing::ahead, Mistake::guides_behind, "the last frame's signal and this frame's albedo",
     "give run() the signal and the guides of one frame: look at double buffers and at what is read back late"},
};

inline EdgeSums const& edges_of(SignalSeen const& signal, Pairing pairing) {
    return signal.notes->edges[static_cast<std::size_t>(pairing)];
}

inline std::string signal_evidence(SignalSeen const& signal, Exponent const& own, Pairing pairing) {
    return "at " + std::to_string(edges_of(signal, pairing).edges) + " edges of albedo '" + signal.name +
           "' goes like albedo to the power of " + text_of(own);
}

/// Whether a signal follows another albedo and not its own. Fine textures whose samples lie anywhere in the pixel leave little of a power,
/// of which many edges then are sure.
inline bool is_other(Exponent const& own, Exponent const& other) {
    if (other.error > 0.12 || other.value > 1.5) return false;
    double const more = other.value - own.value;
    bool const is_sure = more > 0.15 && other.value > 1.8 * own.value && more > 5. * (own.error + other.error);
    return other.value > 0.45 ? more > 0.3 : other.value > 0.3 && is_sure;
}

/// Whether the signal follows an albedo of other rows or of another frame. Samples anywhere in the pixel make each power less.
inline std::optional<Finding> other_albedo_of(SignalSeen const& signal, Exponent const& own) {
    if (own.value > 0.4) return std::nullopt;
    for (auto const& other : other_albedos) {
        auto const e = exponent_of(edges_of(signal, other.pairing));
        if (e && is_other(own, *e))
            return Finding{other.mistake,
                           signal_evidence(signal, own, Pairing::as_given) + ", and with " + other.which + " of " + text_of(*e),
                           other.remedy};
    }
    return std::nullopt;
}

/// Whether too few edges moved so far to tell, but enough to tell some day.
inline bool is_open(SignalSeen const& signal, Pairing pairing) {
    auto const& edges = edges_of(signal, pairing);
    auto const e = exponent_of(edges);
    return 50 * edges.edges > edges_of(signal, Pairing::as_given).edges && !(e && e->error < 0.12 && e->value < 0.3);
}

/// Whether it is divided by albedo already, or one of the two is not linear. Light that albedo has no part in, such as reflections, makes
/// the power a little less than 1.
inline std::optional<Finding> other_power_of(SignalSeen const& signal, Exponent const& own) {
    auto const evidence = signal_evidence(signal, own, Pairing::plain) + ", and not of 1";
    if (own.error < 0.05 && std::abs(own.value) < 0.13)
        return Finding{Mistake::signal_demodulated, evidence, "leave Demodulate{} out, or give the signal with albedo in it"};
    if (own.error < 0.05 && own.value > 0.2 && own.value < 0.62) {
        bool const displayed = signal.notes->brightest <= 1.001f;
        Finding finding{displayed ? Mistake::signal_encoded : Mistake::albedo_squared, evidence, {}};
        finding.or_else = {displayed ? Mistake::albedo_squared : Mistake::signal_encoded};
        finding.remedy =
            std::string(displayed ? "the signal never exceeds 1, so it is most likely encoded for display (sRGB): give linear light"
                                  : "the signal exceeds 1, so albedo is most likely linearised twice: give it as it is reflected") +
            "; compare the albedo of a material with the value that it is known to have: if it is right, the signal is " +
            "encoded, and if it is too dark, albedo is squared";
        return finding;
    }
    if (own.error < 0.15 && own.value > 1.6 && own.value < 3.)
        return Finding{Mistake::albedo_encoded, evidence, "give albedo as a linear colour: textures are mostly stored as sRGB"};
    return std::nullopt;
}

/// What is wrong with a signal that is to follow albedo.
inline std::optional<Finding> of_light_with_albedo(SignalSeen const& signal, Exponent const& own) {
    auto finding = own.error < 0.1 ? other_albedo_of(signal, own) : std::nullopt;
    bool const open = is_open(signal, Pairing::turned) || is_open(signal, Pairing::behind) || is_open(signal, Pairing::ahead);
    auto const plain = exponent_of(edges_of(signal, Pairing::plain));
    // Albedo of another frame or row does not make the signal follow this one more.
    bool const tells = plain && (!open || plain->value > 1.6);
    return finding || !tells ? finding : other_power_of(signal, *plain);
}

/// Whether a signal that the composite, or the host, multiplies by albedo follows it already.
inline std::optional<Finding> albedo_left_in(SignalSeen const& signal, Exponent const& near_edges) {
    auto const plain = exponent_of(edges_of(signal, Pairing::plain));
    auto const own = plain.value_or(near_edges);
    if (own.error > 0.12 || own.value < 0.65 || own.value > 1.5) return std::nullopt;
    return Finding{Mistake::signal_has_albedo, signal_evidence(signal, own, plain ? Pairing::plain : Pairing::as_given) + ", and not of 0",
                   "divide '" + signal.name + "' by albedo, 0 where that is 0: the output is multiplied by it"};
}

/// What the edges of albedo say of the signal, in two frames.
inline void find_signal_mistakes(Observation const& seen, SignalSeen const& signal, std::vector<Finding>& findings) {
    bool const multiplied = seen.factor ? signal.components == 3 && signal.input : signal.times_albedo;
    bool const follows_albedo = signal.demodulated && !seen.factor;
    auto const& albedo = seen.factor ? seen.factor : seen.albedo;
    if (!albedo || !(multiplied || follows_albedo)) return;
    auto& notes = *signal.notes;
    add_edges(seen, signal, albedo);
    for (auto const& patch : notes.patches)
        for (auto const& value : patch.signal)
            for (int c = 0; c < 3; ++c)
                if (is_finite(value[c])) notes.brightest = std::max(notes.brightest, value[c]);
    auto const own = exponent_of(edges_of(signal, Pairing::as_given));
    std::optional<Finding> finding;
    if (own) finding = multiplied ? albedo_left_in(signal, *own) : of_light_with_albedo(signal, *own);
    notes.other_power_in_a_row = finding ? notes.other_power_in_a_row + 1 : 0;
    if (notes.other_power_in_a_row >= 2) findings.push_back(std::move(*finding));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail
