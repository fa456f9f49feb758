#include <doctest/doctest.h>
#include <quell/shader/interpreter.hpp>
#include <quell/shader/recorded.hpp>
#include <quell/shader/write_plan.hpp>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include <cmath>

// Each operation of a recorded kernel against the same of plain floats: recorded, of constants, run, and written.
namespace {

using namespace quell;

template <class Compute> ShaderPlan plan_of(Compute compute) {
    detail::GraphBuilder builder;
    detail::graph_builder = &builder;
    auto const result = compute(detail::uniform(FrameBlock::shutter_word), detail::uniform(FrameBlock::shutter_then_word));
    builder.add({Operation::store, {result.node, RecordedInteger(0).node}});
    detail::graph_builder = nullptr;
    ShaderPlan plan;
    plan.passes.push_back(
        {{.name = "steps", .fraction = 3, .nodes = builder.take(), .planes = {{"output", 0, 1, ShaderBuffer::output, 0}}}, {}});
    plan.output.push_back({"output", 0, 1});
    return plan;
}
/// The value that is stored, which is a constant.
float constant_of(ShaderPlan const& plan) {
    auto const& nodes = plan.passes[0].graph.nodes;
    auto const& value = nodes[static_cast<std::size_t>(nodes.back().of[0])];
    REQUIRE(value.operation == Operation::constant);
    return std::bit_cast<float>(value.payload);
}
std::uint32_t bits_of(float a) { return a != a ? 0x7fc00000u : std::bit_cast<std::uint32_t>(a); }
/// A pass in a language, with the two numbers that it takes called a and b.
std::string text_of(ShaderPlan const& plan, ShaderLanguage language) {
    auto text = shader_text(plan, 0, false, language);
    for (std::string const letter : {"a", "b"}) {
        std::string const name = letter == "a" ? "frame.shutter.x" : "frame.shutter.y";
        for (auto at = text.find(name); at != std::string::npos; at = text.find(name)) text.replace(at, name.size(), letter);
    }
    return text;
}
/// @param of   of two numbers, recorded or plain
/// @param wgsl what is in the shader of WGSL
/// @param glsl what is in that of GLSL; empty: the same
template <class Of> void check(Of of, std::string const& wgsl, std::string const& glsl = {}) {
    CAPTURE(wgsl);
    auto const plan = plan_of([&](Recorded a, Recorded b) { return of(a, b); });
    CHECK(text_of(plan, ShaderLanguage::wgsl).find("= " + wgsl + ";") != std::string::npos);
    CHECK(text_of(plan, ShaderLanguage::glsl).find("= " + (glsl.empty() ? wgsl : glsl) + ";") != std::string::npos);
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    PlanInterpreter interpreter(plan, {1, 1});
    for (float const a : {0.f, -0.f, 0.1f, 1.1f, 2.5f, -7.25f, 33.f, 1e9f, inf, nan})
        for (float const b : {2.5f, -0.f, 3.3f, 0.7f, -7.25f, inf, nan}) {
            CAPTURE(a);
            CAPTURE(b);
            interpreter.run({.size = {1, 1}, .shutter = a, .shutter_then = b});
            CHECK(bits_of(interpreter.plane(ShaderBuffer::output, 0)[0]) == bits_of(of(a, b)));
            auto const of_constants = plan_of([&](Recorded, Recorded) { return of(Recorded(a), Recorded(b)); });
            CHECK(bits_of(constant_of(of_constants)) == bits_of(of(a, b)));
        }
}
auto chosen(auto compute) {
    return [=](auto a, auto b) {
        auto const mask = compute(a, b);
        return select(mask, decltype(a)(1.f), decltype(a)(2.f));
    };
}

} // namespace

TEST_CASE("recorded operations of numbers do what those of floats do, and are written so") {
    check([](auto a, auto b) { return a + b; }, "a + b");
    check([](auto a, auto b) { return a - b; }, "a - b");
    check([](auto a, auto b) { return a * b; }, "a * b");
    check([](auto a, auto b) { return a / b; }, "a / b");
    check([](auto a, auto) { return -a; }, "-a");
    check([](auto a, auto b) { return quell::min(a, b); }, "select(b, a, a < b)", "a < b ? a : b");
    check([](auto a, auto b) { return quell::max(a, b); }, "select(b, a, a > b)", "a > b ? a : b");
    check([](auto a, auto) { return quell::abs(a); }, "abs(a)");
    check([](auto, auto b) { return quell::sqrt(b); }, "sqrt(b)");
    check([](auto a, auto) { return quell::floor(a); }, "floor(a)");
    check([](auto a, auto b) { return quell::fma(a, b, a); }, "fma(a, b, a)");
    check([](auto a, auto b) { return select(a < b, b, a); }, "select(a, b, v3)", "v3 ? b : a");
}

TEST_CASE("recorded comparisons do what those of floats do, and are written so") {
    check(chosen([](auto a, auto b) { return a < b; }), "a < b");
    check(chosen([](auto a, auto b) { return a <= b; }), "a <= b");
    check(chosen([](auto a, auto b) { return a > b; }), "a > b");
    check(chosen([](auto a, auto b) { return a >= b; }), "a >= b");
    check(chosen([](auto a, auto b) { return a == b; }), "a == b");
    check(chosen([](auto a, auto b) { return a != b; }), "a != b");
    check(chosen([](auto a, auto b) {
              auto const less = a < b;
              return both(less, is_finite(a));
          }),
          "v3 && v4");
    check(chosen([](auto a, auto b) {
              auto const less = a < b;
              return either(less, sign_bit(a));
          }),
          "v3 || v4");
    check(chosen([](auto a, auto b) { return invert(a < b); }), "!v3");
    check(chosen([](auto a, auto) { return sign_bit(a); }), "bitcast<i32>(a) < 0", "floatBitsToInt(a) < 0");
}

TEST_CASE("recorded operations of integers do what those of C++ do, and are written so") {
    auto const each = [](auto compute, std::string const& sign) {
        CAPTURE(sign);
        auto const plan = plan_of([&](Recorded a, Recorded b) { return to_real(compute(truncate(a), truncate(b))); });
        CHECK(text_of(plan, ShaderLanguage::glsl).find(" " + sign + " v") != std::string::npos);
        PlanInterpreter interpreter(plan, {1, 1});
        for (int const i : {-9, -7, 0, 3, 8})
            for (int const j : {0, 1, 5}) {
                auto const expected = static_cast<float>(compute(i, j));
                interpreter.run({.size = {1, 1}, .shutter = static_cast<float>(i), .shutter_then = static_cast<float>(j)});
                CHECK(interpreter.plane(ShaderBuffer::output, 0)[0] == expected);
                CHECK(constant_of(plan_of([&](Recorded, Recorded) { return to_real(compute(RecordedInteger(i), RecordedInteger(j))); })) ==
                      expected);
            }
    };
    each([](auto i, auto j) { return i + j; }, "+");
    each([](auto i, auto j) { return i - j; }, "-");
    each([](auto i, auto j) { return i * j; }, "*");
    each([](auto i, auto j) { return i & j; }, "&");
    each([](auto i, auto j) { return i | j; }, "|");
    each([](auto i, auto j) { return i ^ j; }, "^");
    each([](auto i, auto j) { return i >> j; }, ">>");
    each([](auto i, auto j) { return (i & 7) << j; }, "<<");
}

TEST_CASE("a pass of a part of the size is as large as it is rounded up") {
    auto const plan = plan_of([](Recorded a, Recorded) { return a; });
    CHECK(text_of(plan, ShaderLanguage::wgsl).find("if (x >= (frame.size.x + 2) / 3 || y >= (frame.size.y + 2) / 3)") != std::string::npos);
}

TEST_CASE("the block of a frame has its members where it says, and its rays go through pixels' samples") {
    glm::vec3 const eye(1, 2, 9);
    Extent const size{40, 24};
    Camera const camera{
        glm::lookAt(eye, glm::vec3(0, 1, -3), glm::vec3(0, 1, 0)), glm::perspective(.9f, 40.f / 24.f, .1f, 100.f), {.25f, -.5f}};
    Camera const then{glm::mat4(1.f), glm::perspective(.7f, 40.f / 24.f, .1f, 100.f), {.125f, .75f}};
    FrameBlock const block{size, 7, camera, then, .5f, .25f, true};
    auto const words = block.as_words();
    int next = 0;
    auto const member = [&](std::string_view name) {
        auto const found = std::ranges::find(FrameBlock::members, name, &FrameBlock::Member::name);
        REQUIRE(found != FrameBlock::members.end());
        CHECK(found->word == next); // in order, one behind the other
        next += found->type == "mat4" ? 16 : 4;
        return [&words, word = found->word](int i) { return std::bit_cast<float>(words[static_cast<std::size_t>(word + i)]); };
    };
    auto const clip = member("clip_from_world"), clip_then = member("clip_from_world_then");
    for (auto const& [numbers, of] : {std::pair{clip, camera}, {clip_then, then}})
        for (int i = 0; i < 16; ++i) CHECK(numbers(i) == of.clip_from_world()[i / 4][i % 4]);
    auto const rays_of = [&](std::string const& suffix, Camera const& of) {
        auto const from = member("eye" + suffix), forward = member("forward" + suffix), right = member("right" + suffix),
                   down = member("down" + suffix);
        for (glm::vec2 const place : {glm::vec2(0, 0), glm::vec2(13.5f, 20.25f)}) {
            glm::vec4 world(0, 0, 0, 1);
            for (int c = 0; c < 3; ++c) world[c] = from(c) + 5.f * (forward(c) + place.x * right(c) + place.y * down(c));
            auto const seen = of.clip_from_world() * world;
            CHECK(seen.w == doctest::Approx(5.f)); // the depth
            CHECK((seen.x / seen.w + 1.f) / 2.f * 40.f == doctest::Approx(place.x).epsilon(1e-4));
            CHECK((1.f - seen.y / seen.w) / 2.f * 24.f == doctest::Approx(place.y).epsilon(1e-4));
        }
    };
    rays_of("", camera), rays_of("_then", then);
    auto const jitter = member("jitter"), shutter = member("shutter");
    CHECK(glm::vec4(jitter(0), jitter(1), jitter(2), jitter(3)) == glm::vec4(.25f, -.5f, .125f, .75f));
    CHECK(glm::vec2(shutter(0), shutter(1)) == glm::vec2(.5f, .25f));
    member("size");
    CHECK((words[72] == 40 && words[73] == 24 && words[74] == 7 && next == FrameBlock::words));
    auto const json = to_json(plan_of([](Recorded a, Recorded) { return a; }), "wgsl");
    CHECK(json.find("\"name\": \"down\", \"type\": \"vec4\", \"offset\": 176") != std::string::npos);
}
