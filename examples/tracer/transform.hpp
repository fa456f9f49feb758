#pragma once

#include "math.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <functional>
#include <vector>

namespace quell::tracer {

/// A placement without shear: scale first, then rotation, then translation.
struct Transform {
    glm::vec3 translation{0.f};
    glm::quat rotation{1.f, 0.f, 0.f, 0.f};
    glm::vec3 scale{1.f};

    [[nodiscard]] glm::mat4 matrix() const {
        return glm::scale(glm::translate(glm::mat4{1.f}, translation) * glm::mat4_cast(rotation), scale);
    }
};

enum class Interpolation { step, linear, cubic };

/// A value at a moment; the tangents (per frame) matter for cubic interpolation only.
template <class Value> struct Key {
    float frame = 0;
    Value value{};
    Value tangent_in{}, tangent_out{};
};

namespace detail {
inline glm::vec3 blend(glm::vec3 a, glm::vec3 b, float t) { return glm::mix(a, b, t); }
inline glm::quat blend(glm::quat a, glm::quat b, float t) { return glm::slerp(a, b, t); }
inline glm::vec3 tidied(glm::vec3 value) { return value; }
inline glm::quat tidied(glm::quat value) { return glm::normalize(value); }

/// Cubic Hermite segment.
template <class Value> Value hermite(Key<Value> const& a, Key<Value> const& b, float t) {
    float const length = b.frame - a.frame, t2 = t * t, t3 = t2 * t;
    return tidied(a.value * (2 * t3 - 3 * t2 + 1) + a.tangent_out * ((t3 - 2 * t2 + t) * length) + b.value * (3 * t2 - 2 * t3) +
                  b.tangent_in * ((t3 - t2) * length));
}
} // namespace detail

/// A value over time, from keys in ascending order: constant before the first and after the last, or repeating.
template <class Value> struct Track {
    std::vector<Key<Value>> keys;
    Interpolation interpolation = Interpolation::linear;
    float period = 0; ///< frames after which it repeats; 0 means never

    [[nodiscard]] Value at(float frame) const {
        if (period > 0) frame -= period * std::floor(frame / period);
        auto const next = std::ranges::upper_bound(keys, frame, {}, &Key<Value>::frame);
        if (next == keys.begin()) return keys.front().value;
        if (next == keys.end()) return keys.back().value;
        return between(*std::prev(next), *next, frame);
    }

private:
    [[nodiscard]] Value between(Key<Value> const& a, Key<Value> const& b, float frame) const {
        float const t = (frame - a.frame) / (b.frame - a.frame);
        if (interpolation == Interpolation::step) return a.value;
        if (interpolation == Interpolation::cubic) return detail::hermite(a, b, t);
        return detail::blend(a.value, b.value, t);
    }
};

/// Where something is at a moment, in frames (fractions allowed), relative to its parent.
using Pose = std::function<glm::mat4(float frame)>;

inline Pose fixed(Transform const& transform) {
    return [matrix = transform.matrix()](float) { return matrix; };
}

} // namespace quell::tracer
