#include "digest.hpp"
#include "prepared.hpp"
#include "tied.hpp"

#include <array>
#include <string>

namespace quell::tracer {
namespace {

template <class Value> inline constexpr bool is_plain = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;
template <int n, class Number, glm::qualifier q> inline constexpr bool is_plain<glm::vec<n, Number, q>> = true;
template <int n, int m, class Number, glm::qualifier q> inline constexpr bool is_plain<glm::mat<n, m, Number, q>> = true;

/// A digest of whatever a scene is made of. What this doesn't know how to add doesn't compile.
class SceneDigest {
public:
    /// Functions of time count by what they give at these moments: they themselves can't be compared.
    explicit SceneDigest(std::vector<float> moments_) : moments(std::move(moments_)) { add(moments); }

    template <class Value>
        requires is_plain<Value>
    void add(Value const& value) { digest.add(value); }
    void add(std::string const& text) { digest.add(text); }
    template <class Value> void add(std::vector<Value> const& values) {
        if constexpr (is_plain<Value>) return digest.add(values);
        digest.add(values.size());
        for (auto const& value : values) add(value);
    }
    template <Tied Value> void add(Value const& value) {
        static_assert(ties_all_members<Value>(), "tie() leaves out a member");
        std::apply([&](auto const&... members) { (add(members), ...); }, value.tie());
    }
    template <class Value> void add(std::function<Value(float)> const& over_time) {
        add(over_time != nullptr);
        for (float const moment : moments)
            if (over_time) add(over_time(moment));
    }
    // What a scene does without leaves its digest as it is: then what was rendered before there was such a thing still counts.
    void add(Lens const& lens) {
        if (lens) digest.add(std::array{lens.radius, lens.focus});
    }
    void add(Coverage const& coverage) {
        if (coverage) digest.add(coverage.part);
    }
    /// It needs a mesh: content_hash() adds the vertices that come of it.
    void add(Deformation const& deformation) { add(deformation != nullptr); }

    [[nodiscard]] std::uint64_t value() const { return digest.value(); }

private:
    Digest digest;
    std::vector<float> moments;
};

} // namespace

std::uint64_t PreparedScene::content_hash() const {
    SceneDigest digest{moments_before(0)};
    digest.add(scene);
    for (auto const& deformation : deformations) digest.add(deformation.now);
    return digest.value();
}

} // namespace quell::tracer
