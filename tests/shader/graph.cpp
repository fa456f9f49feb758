#include "two_sizes.hpp"

#include <quell/shader/interpreter.hpp>
#include <quell/shader/record.hpp>
#include <quell/shader/write_plan.hpp>

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace quell;

/// Steps of what `compute` does to two numbers that are not known: the words 0 and 1 of the block.
template <class Compute> std::vector<Node> steps(Compute compute) {
    detail::GraphBuilder builder;
    detail::graph_builder = &builder;
    auto const result = compute(detail::uniform(0), detail::uniform(1));
    builder.add({Operation::store, {result.node, RecordedInteger(0).node}});
    detail::graph_builder = nullptr;
    return builder.take();
}
std::size_t count(std::vector<Node> const& nodes, Operation operation) {
    return static_cast<std::size_t>(std::ranges::count(nodes, operation, &Node::operation));
}
/// A plan of one pass that does this, as steps().
template <class Compute> ShaderPlan plan_of(Compute compute) {
    ShaderPlan plan;
    plan.passes.push_back({{.name = "steps", .nodes = steps(compute), .planes = {{"output", 0, 1, ShaderBuffer::output, 0}}}, {}});
    plan.output.push_back({"output", 0, 1});
    return plan;
}
/// The value that is stored, if it is a constant.
float constant_of(std::vector<Node> const& nodes) {
    auto const& value = nodes[static_cast<std::size_t>(nodes.back().of[0])];
    REQUIRE(value.operation == Operation::constant);
    return std::bit_cast<float>(value.payload);
}

} // namespace

TEST_CASE("recorded: equal steps are one, dead ones are gone") {
    auto const nodes = steps([](Recorded a, Recorded b) {
        auto const dead = a / b;
        static_cast<void>(dead);
        return (a + b) * (a + b);
    });
    CHECK(count(nodes, Operation::add) == 1);
    CHECK(count(nodes, Operation::multiply) == 1);
    CHECK(count(nodes, Operation::divide) == 0);
}

TEST_CASE("recorded: constants are computed") {
    CHECK(constant_of(steps([](Recorded, Recorded) { return exp(Recorded(1.f)); })) == quell::exp(1.f));
    CHECK(constant_of(steps([](Recorded a, Recorded b) { return select(a < b, Recorded(3.f), Recorded(3.f)); })) == 3.f);
}

TEST_CASE("recorded: any() of what is not known is true, all() is false") {
    steps([](Recorded a, Recorded b) {
        CHECK(any(a < b));
        CHECK_FALSE(all(a < b));
        CHECK_FALSE(any(both(a < b, Recorded(1.f) < Recorded(0.f))));
        CHECK(all(either(a < b, Recorded(0.f) < Recorded(1.f))));
        return a;
    });
}

TEST_CASE("recorded: a loop has as many turns as a pixel wants, and hands on what it is told to") {
    auto const fibonacci = [](Recorded, Recorded factor) {
        vec2<Recorded> two{Recorded(1.f), Recorded(1.f)};
        Recorded turns(0.f);
        for_each_turn(
            detail::uniform(FrameBlock::shutter_word),
            [&](Recorded turn) {
                two = {two.y, fma(two.x, factor / factor, two.y)};
                turns = turn + 1.f;
            },
            two, turns);
        return two.x + turns * 100.f;
    };
    auto const plan = plan_of(fibonacci);
    auto const& nodes = plan.passes[0].graph.nodes;
    auto const place = [&](Operation operation) { return std::ranges::find(nodes, operation, &Node::operation) - nodes.begin(); };
    CHECK(count(nodes, Operation::carried) == 3);
    CHECK(place(Operation::divide) < place(Operation::loop)); // is the same in each turn
    CHECK(place(Operation::fused) > place(Operation::loop));
    CHECK(place(Operation::fused) < place(Operation::end_loop));
    auto const wgsl = shader_text(plan, 0, false, ShaderLanguage::wgsl);
    CHECK(wgsl.find(" += 1.0) {\n        let v") != std::string::npos);
    CHECK(wgsl.find("    var v") != std::string::npos);
    PlanInterpreter interpreter(plan, {1, 1});
    std::pair<float, float> const expected[] = {{0.f, 1.f}, {1.f, 101.f}, {2.f, 202.f}, {6.5f, 721.f}, {-3.f, 1.f}};
    for (auto const& [turns, result] : expected) {
        FrameBlock block{.size = {1, 1}, .shutter = turns};
        block.camera.projection[0][1] = 1.f; // word 1 of the block
        interpreter.run(block);
        CHECK(interpreter.plane(ShaderBuffer::output, 0)[0] == result);
    }
}

TEST_CASE("recorded: loops within loops, and loops that nothing needs") {
    auto const nodes = steps([](Recorded a, Recorded b) {
        Recorded sum(0.f), dead(0.f);
        for_each_turn(
            a,
            [&](Recorded) {
                for_each_turn(
                    b, [&](Recorded turn) { sum += turn; }, sum);
            },
            sum);
        for_each_turn(
            a, [&](Recorded) { dead += b; }, dead);
        return sum;
    });
    CHECK(count(nodes, Operation::loop) == 2);
    CHECK(count(nodes, Operation::end_loop) == 2);
}

TEST_CASE("recorded: what a loop changes without saying so is an error") {
    CHECK_THROWS_WITH_AS(steps([](Recorded a, Recorded b) {
                             Recorded sum(0.f);
                             for_each_turn(a, [&](Recorded turn) { sum += turn; });
                             return sum * b;
                         }),
                         doctest::Contains("what a loop computes is used behind it"), Failure);
}

TEST_CASE("recorded: vectors of GLM") {
    auto const nodes = steps([](Recorded a, Recorded b) {
        vec3<Recorded> v{a, b, Recorded(1.f)};
        v += v * b;
        return dot(v, -v);
    });
    CHECK(count(nodes, Operation::multiply) == 4); // three of v * b, and the last of dot
    CHECK(count(nodes, Operation::fused) == 2);
}

TEST_CASE("a plan: what a shader must know of planes and passes") {
    auto const plan = record(tests::two_sizes, "two sizes");
    REQUIRE(plan.passes.size() == 4);
    CHECK(plan.passes[1].graph.name == "temporal");
    CHECK(plan.passes[1].first);
    CHECK_FALSE(plan.passes[0].first);
    CHECK(plan.passes[2].graph.fraction == 2);
    CHECK(plan.output.size() == 3);
    CHECK(plan.inputs.size() == 3 + 2 + 1 + 3); // radiance, motion, depth, normal
    // Signal and length of the history; depth, and normal in a word.
    CHECK(plan.history_slots == 3 + 1 + 1 + 1);
    auto const json = to_json(plan, "wgsl");
    CHECK(json.find("\"first\": \"01-temporal-first.wgsl\"") != std::string::npos);
    CHECK(json.find("\"name\": \"history_then\", \"binding\": 2, \"access\": \"read\", \"slots\": 6") != std::string::npos);
    // What is read and what is written have registers of their own in HLSL; Metal has no function `main`.
    CHECK(to_json(plan, "hlsl").find("\"binding\": 2, \"register\": \"t2\", \"access\": \"read\"") != std::string::npos);
    CHECK(to_json(plan, "hlsl").find("\"binding\": 3, \"register\": \"u3\"") != std::string::npos);
    CHECK(to_json(plan, "metal").find("\"entry_point\": \"main0\"") != std::string::npos);
    auto const shader = shader_text(plan, 2, false, ShaderLanguage::wgsl);
    CHECK(shader.find("// quell, two sizes: ") == 0);
    CHECK(shader.find("; // smaller[0]") != std::string::npos);
    CHECK(to_string(plan.passes[1].graph).find("history_then") != std::string::npos);
}

TEST_CASE("a plan: buffers in parts, of which a shader has those that it uses") {
    auto const plan = record(tests::two_sizes, "two sizes", {.most_slots = 4});
    auto const has = [](std::string const& text, char const* what) { return text.find(what) != std::string::npos; };
    auto const json = to_json(plan, "wgsl");
    CHECK(has(json, R"("name": "inputs_3", "binding": 3, "access": "read", "slots": 1})"));
    CHECK(has(json, R"("name": "history_then_2", "binding": 5, "access": "read", "slots": 2, "becomes": "history_now_2"})"));
    CHECK(has(json, R"("component": 0, "fraction": 1, "buffer": "inputs_2", "slot": 1})"));
    CHECK(has(json, R"("shader": "00-ingest.wgsl", "fraction": 1, "reads": ["inputs"], "writes": ["scratch"])"));
    auto const wgsl = shader_text(plan, 2, false, ShaderLanguage::wgsl); // makes `smaller` of the signal
    CHECK_FALSE(has(wgsl, "inputs"));
    CHECK(has(shader_text(plan, 1, false, ShaderLanguage::wgsl), "@binding(5) var<storage, read> history_then_2: array<u32>;"));
    CHECK(has(shader_text(plan, 1, false, ShaderLanguage::glsl), "binding = 5) readonly buffer Buffer5 { uint history_then_2[]; };"));
}

TEST_CASE("a plan with views of its buffers: shaders load of them what they do not write") {
    auto const plain = record(tests::two_sizes, "two sizes");
    auto const plan = record(tests::two_sizes, "two sizes", {.texel_loads = true, .workgroup = {64, 1}});
    auto const has = [](std::string const& text, std::string const& what) { return text.find(what) != std::string::npos; };
    auto const json = to_json(plan, "comp");
    CHECK(has(json, R"("workgroup": [64, 1])"));
    CHECK(has(json, R"("name": "inputs", "binding": 1, )"));
    CHECK(has(json, R"("view": {"binding": 6, "format": "R32_SFLOAT"})"));
    CHECK(has(json, R"("view": {"binding": 9, "format": "R32_UINT"})"));
    CHECK_FALSE(has(json, R"("view": {"binding": 10)")); // no pass loads of the picture
    CHECK_FALSE(has(to_json(plain, "comp"), "view"));
    int loads = 0, stores = 0;
    for (std::size_t pass = 0; pass < plan.passes.size(); ++pass)
        for (bool const is_first : {false, true}) {
            auto const glsl = shader_text(plan, pass, is_first, ShaderLanguage::glsl);
            CHECK(has(glsl, "layout(local_size_x = 64, local_size_y = 1) in;"));
            CHECK(has(glsl, "layout(set = 0, binding = 6) uniform samplerBuffer inputs_texels;"));
            CHECK(has(glsl, "layout(set = 0, binding = 9) uniform usamplerBuffer scratch_texels;"));
            CHECK_FALSE(has(glsl, "= inputs["));
            for (auto const* const name : {"history_now", "scratch"})
                for (int slot = 0; slot < 32; ++slot) {
                    auto const place = std::to_string(slot) + " * pixels + ";
                    bool const is_stored = has(glsl, "    " + std::string(name) + "[" + place);
                    bool const is_fetched = has(glsl, "texelFetch(" + std::string(name) + "_texels, " + place);
                    CHECK_FALSE((is_stored && is_fetched));
                    loads += is_fetched, stores += is_stored;
                }
        }
    CHECK((loads > 0 && stores > 0));
    CHECK(has(shader_text(plan, 1, false, ShaderLanguage::wgsl), "@workgroup_size(64, 1)"));
    CHECK_FALSE(has(shader_text(plan, 1, false, ShaderLanguage::wgsl), "texel"));
}

TEST_CASE("a plan in half precision: two planes of a pass share words, a pixel's alone") {
    auto const plan = record(tests::two_sizes, "two sizes", {.half_precision = true}), whole = record(tests::two_sizes, "two sizes");
    auto const has = [](std::string const& text, char const* what) { return text.find(what) != std::string::npos; };
    CHECK(plan.history_slots == 2 + 1 + 1); // signal and length of the history; depth; normal
    CHECK(plan.scratch_slots < whole.scratch_slots);
    CHECK(has(to_string(plan.passes[0].graph), ": signal[0], signal[1]"));
    auto const temporal = to_string(plan.passes[1].graph);
    CHECK(has(temporal, " = pack halves "));
    CHECK(has(temporal, " = upper half "));
    for (auto const& pass : plan.passes)
        for (auto const& plane : pass.graph.planes)
            if (!plane.beside.empty()) CHECK((plane.is_half && holds_words(plane.buffer)));
    auto const wgsl = shader_text(plan, 1, false, ShaderLanguage::wgsl), glsl = shader_text(plan, 1, false, ShaderLanguage::glsl);
    CHECK(has(wgsl, " = unpack2x16float(w"));
    CHECK(has(glsl, " = unpackHalf2x16(w"));
    CHECK(has(glsl, " = packed_halves(v"));
    CHECK_FALSE(has(shader_text(whole, 1, false, ShaderLanguage::wgsl), "halves"));
}

TEST_CASE("packing halves rounds as the CPU, and leaves loops whole") {
    // What a pass would store in two planes: f(turns) of a loop, and a number of the block.
    detail::GraphBuilder builder;
    detail::graph_builder = &builder;
    Recorded sum(0.f);
    for_each_turn(
        Recorded(3.f), [&](Recorded turn) { sum += turn * detail::uniform(0); }, sum);
    std::uint32_t plane = 0;
    for (auto const value : {sum, detail::uniform(1)}) {
        auto const half = detail::recorded<Recorded>(Operation::round_to_half, value);
        builder.add({Operation::store, {half.node, RecordedInteger(0).node}, plane++});
    }
    detail::graph_builder = nullptr;
    PassGraph const written{"steps", 1, builder.take(), {{"a"}, {"b"}}};
    PassGraph read{"read", 1, {}, {{"a"}, {"b"}, {"output", 0, 1, ShaderBuffer::output, 0}, {"output", 1, 1, ShaderBuffer::output, 1}}};
    read.nodes = {{Operation::constant},     {Operation::constant_integer}, {Operation::load, {1}, 1},
                  {Operation::load, {1}, 0}, {Operation::store, {3, 1}, 2}, {Operation::store, {2, 1}, 3}};
    using enum detail::WordPart;
    ShaderPlan plan{.name = "halves", .passes = {}, .inputs = {}, .output = {{"a"}, {"b"}}, .scratch_slots = 1};
    plan.passes.push_back({detail::HalfPacker(written, {lower, upper}).take(), {}});
    plan.passes.push_back({detail::HalfPacker(read, {lower, upper, whole, whole}).take(), {}});
    CHECK(plan.passes[1].graph.planes.size() == 3);
    CHECK(count(plan.passes[1].graph.nodes, Operation::load) == 1);
    CHECK(count(plan.passes[0].graph.nodes, Operation::round_to_half) == 0);
    PlanInterpreter interpreter(plan, {1, 1});
    for (float const value : {0.f, -0.1f, 1.0005f, 65520.f, -1e30f, 3e-6f, std::numeric_limits<float>::infinity()}) {
        FrameBlock block{.size = {1, 1}};
        block.camera.projection[0][0] = 1.0005f, block.camera.projection[0][1] = value; // words 0 and 1 of the block
        interpreter.run(block);
        CHECK(interpreter.plane(ShaderBuffer::output, 0)[0] == float_from_half(half_from_float(3.f * 1.0005f)));
        CHECK(interpreter.plane(ShaderBuffer::output, 1)[0] == float_from_half(half_from_float(value)));
    }
}

TEST_CASE("a shader keeps words that are no numbers as integers") {
    auto const plan = record(tests::two_sizes, "two sizes");
    auto const of_language = [&](ShaderLanguage language) { return shader_text(plan, 1, false, language); };
    auto const has = [](std::string const& text, char const* what) { return text.find(what) != std::string::npos; };
    auto const wgsl = of_language(ShaderLanguage::wgsl), glsl = of_language(ShaderLanguage::glsl);
    CHECK(has(wgsl, "> history_then: array<u32>;"));
    CHECK(has(wgsl, "> inputs: array<f32>;"));
    CHECK(has(glsl, "{ uint history_now[]; };"));
    CHECK(has(glsl, "{ float picture[]; };"));
    // The last frame's normal in one word: never a float on its way.
    auto const load = wgsl.substr(0, wgsl.find("; // packed normal[0]"));
    auto const name = load.substr(load.rfind("let ") + 4, load.rfind(" = ") - load.rfind("let ") - 4);
    CHECK(has(wgsl, ("= i32(" + name + ");").c_str()));
    CHECK_FALSE(has(wgsl, ("bitcast<f32>(" + name + ")").c_str()));
    auto const last = shader_text(plan, 3, false, ShaderLanguage::wgsl);
    CHECK(last.substr(last.rfind(" = ", last.find("; // packed normal[0]")), 7) == " = u32(");
}
