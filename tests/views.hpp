#pragma once

#include "frames.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

// Cameras in double precision and what they see: the truth that motion sources are held against.
namespace quell::tests {

/// A camera, and the same in double precision.
struct View {
    glm::dmat4 view, projection;
    Extent size;
    glm::dvec3 eye;

    View(glm::dvec3 eye_, glm::dvec3 target, Extent size_, glm::dvec3 up = {0, 1, 0})
        : view(glm::lookAt(eye_, target, up)),
          projection(glm::perspective(0.9, static_cast<double>(size_.width) / size_.height, 0.1, 100.0)), size(size_), eye(eye_) {}

    [[nodiscard]] Camera camera() const { return {glm::mat4(view), glm::mat4(projection), glm::vec2(0)}; }
    /// In pixels.
    [[nodiscard]] glm::dvec2 project(glm::dvec3 p) const {
        auto const clip = projection * view * glm::dvec4(p, 1);
        return {(clip.x / clip.w + 1) * 0.5 * size.width, (1 - clip.y / clip.w) * 0.5 * size.height};
    }
    [[nodiscard]] double depth(glm::dvec3 p) const { return -(view * glm::dvec4(p, 1)).z; }
    /// Of the ray through a place of the image; of length 1.
    [[nodiscard]] glm::dvec3 direction(glm::dvec2 where) const {
        auto const far = glm::inverse(projection * view) * glm::dvec4(2 * where.x / size.width - 1, 1 - 2 * where.y / size.height, 0.5, 1);
        return glm::normalize(glm::dvec3(far) / far.w - eye);
    }
};

inline glm::dvec2 centre(int x, int y) { return {x + 0.5, y + 0.5}; }

/// Where a line meets a plane.
inline glm::dvec3 meet(glm::dvec3 from, glm::dvec3 direction, glm::dvec3 point, glm::dvec3 normal) {
    return from + direction * (glm::dot(point - from, normal) / glm::dot(direction, normal));
}
inline glm::dvec3 mirrored(glm::dvec3 a, glm::dvec3 point, glm::dvec3 normal) { return a - normal * (2 * glm::dot(a - point, normal)); }

/// Where a pixel sees the ground, which is the plane y = 0.
inline glm::dvec3 ground(View const& view, int x, int y) { return meet(view.eye, view.direction(centre(x, y)), {}, {0, 1, 0}); }
/// A frame in which nothing moves, in front of a camera that sees the ground and nothing else.
template <class F> void fill_ground(F& frame, View const& view) {
    fill_still(frame);
    frame.camera = view.camera();
    auto const seen = [&](int x, int y) { return glm::vec3(ground(view, x, y)); };
    fill(frame[position], seen);
    fill(frame[receiver_previous], seen);
    fill(frame[normal], [](int, int) { return glm::vec3(0, 1, 0); });
    fill(frame[depth], [&](int x, int y) { return static_cast<float>(view.depth(ground(view, x, y))); });
}

/// What a pipeline makes of the last of two frames, in which nothing moves but what `then` and `now` say.
template <class P> std::vector<float> last_of_two(P const& pipeline, auto&& frame, auto&& then, auto&& now) {
    History history{frame.size, pipeline};
    fill_still(frame);
    then(frame);
    run(pipeline, frame, history);
    now(frame);
    return copy_of(run(pipeline, frame, history));
}
/// The same of visibility, a pattern, in a world that knows how to fill a frame as it was then and as it is now. `change` is made to the
/// last frame. The first shows the surfaces of now from the camera of then, so that they are found in the history.
template <class P> std::vector<float> after(P const& pipeline, auto&& frame, auto const& world, auto&& change) {
    return last_of_two(
        pipeline, frame,
        [&](auto& first) {
            fill(first[visibility], [](int x, int y) { return static_cast<float>((x * 7 + y * 3) % 5); });
            world.fill_now(first);
            world.fill_then(first);
        },
        [&](auto& last) {
            world.fill_now(last);
            change(last);
        });
}

/// Components, three at a time.
inline std::vector<glm::vec3> in_threes(std::vector<float> const& components) {
    std::vector<glm::vec3> all;
    for (std::size_t i = 0; i + 2 < components.size(); i += 3) all.emplace_back(components[i], components[i + 1], components[i + 2]);
    return all;
}

/// A history fetch that shows what the motion source has said: place and validity. Wants a signal of three components.
struct ShowPlace {
    template <class Px, class Found> QUELL_KERNEL auto fetch(Px const&, Found const& found) const {
        using Real = typename Px::Real;
        auto past = detail::no_past<Px>();
        past.signal = vec3<Real>{found.where.x, found.where.y, found.validity};
        past.validity = Real(1.f);
        return past;
    }
};
struct TakePast {
    QUELL_KERNEL auto blend(auto, auto past) const { return past.signal; }
};
/// A pipeline whose output is the places that a source says.
template <class M> constexpr auto places_of(M const& source) { return Pipeline{radiance, Temporal{source, TakePast{}, ShowPlace{}}}; }

/// The places that a source says in the last of two frames.
template <class M> std::vector<glm::vec3> places(M const& source, Extent size, auto&& then, auto&& now) {
    auto const show = places_of(source);
    return in_threes(last_of_two(show, Frame{size, show}, then, now));
}

/// The greatest distance, in pixels, from f(x, y); infinite where a place is not valid.
double farthest(std::vector<glm::vec3> const& places, Extent size, auto&& f) {
    double worst = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const& a = places[static_cast<std::size_t>(y * size.width + x)];
            double const d = a.z > 0 ? glm::length(glm::dvec2(a.x, a.y) - glm::dvec2(f(x, y))) : 1e30;
            worst = d <= worst ? worst : d;
        }
    return worst;
}
inline bool none_valid(std::vector<glm::vec3> const& places) {
    for (auto const& a : places)
        if (!(a.z == 0.f)) return false;
    return true;
}

} // namespace quell::tests
