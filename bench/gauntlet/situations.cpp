#include <gauntlet/situations.hpp>
#include <gauntlet/worlds.hpp>

#include <functional>

namespace quell::gauntlet {

namespace {

using Change = std::function<void(Shot&)>;

/// A shot with a change.
Shot but(Shot shot, Change const& change) {
    change(shot);
    return shot;
}
Shot shot_of(World world, Path path = Path::dolly) { return {.world = std::move(world), .path = path}; }

/// Shots in which all is as it should be, by the names that twins have.
struct Right {
    Shot court = shot_of(quell::gauntlet::court()), still = shot_of(quell::gauntlet::court(), Path::still);
    Shot turning = shot_of(quell::gauntlet::court(), Path::turns), drops = shot_of(quell::gauntlet::drops());
    Shot zoom = shot_of(plain_court(), Path::zooms), shift = shot_of(plain_court(), Path::shifts);
    Shot own = but(shot_of(plain_court()), [](Shot& s) { s.names = Names::own; });
    Shot breathing = but(court, [](Shot& s) { s.world.things[court_ball].breath = 0.25; });
    Shot metal = but(own, [](Shot& s) {
        auto& ball = s.world.things[court_ball];
        ball.is_apart = true, ball.material.gloss = 0.9, ball.material.roughness = 0.4;
    });
    Shot fast = but(still, [](Shot& s) {
        auto& ball = s.world.things[court_ball];
        ball.is_apart = true, ball.speed = {0.09, 0., 0.01};
        s.world.things[court_box].is_apart = true, s.world.things[court_box].spin = 0.04;
    });
    Shot layers = but(court, [](Shot& s) { s.has_layers = true; });
};

Situation right(std::string name, std::string about, Shot shot, bool is_small = false) {
    return {.name = std::move(name), .about = std::move(about), .shot = std::move(shot), .is_small = is_small};
}

void add_right(std::vector<Situation>& list, Right const& all) {
    list.push_back(right("court", "nothing: the camera goes sideways", all.court, true));
    list.push_back(right("still", "nothing: the camera stands", all.still));
    list.push_back(right("turning", "nothing: the camera turns, and vectors say so of the sky", all.turning));
    list.push_back(right("zoom", "nothing: the lens becomes longer, and vectors say so", all.zoom));
    list.push_back(right("shift", "nothing: the lens is shifted, and vectors say so", all.shift));
    list.push_back(right("drops", "nothing: drops fly before the sky", all.drops));
    list.push_back(right("breathing", "nothing: a ball grows and shrinks, and vectors say so", all.breathing));
    list.push_back(right("own", "nothing: a picture with an albedo", all.own));
    list.push_back(right("metal", "nothing: a rough metal ball with an albedo", all.metal));
    list.push_back(right("fast", "nothing: a ball rolls and a box turns before a still camera", all.fast));
}

/// Motion that vectors do not tell.
void add_untold_motion(std::vector<Situation>& list, Right const& all) {
    auto const add = [&](char const* name, char const* about, char const* twin, Shot const& from, Change const& change, bool is_small = false) {
        list.push_back({name, about, but(from, change), twin, is_small});
    };
    add("sky-turns", "vectors are 0 for the sky while the camera turns", "turning", all.turning,
        [](Shot& s) { s.vectors = Vectors::sky_zero, s.part = Part::sky; }, true);
    add("clouds", "the sky's pattern turns by itself", "still", all.still,
        [](Shot& s) { s.world.sky.spin = 0.02, s.vectors = Vectors::rigid, s.part = Part::sky; });
    add("film", "a screen plays a film", "court", all.court, [](Shot& s) {
        auto& screen = s.world.things[court_screen];
        screen.is_apart = true, screen.material.film = 0.3, screen.material.flickers = true, s.part = Part::things;
    }, true);
    add("scroll", "a texture goes over a wall that stands", "still", all.still, [](Shot& s) {
        s.world.things[court_screen].is_apart = true, s.world.things[court_screen].material.film = 0.35, s.part = Part::things;
    });
    add("glow-film", "a screen that sends out light plays a film", "court", all.court, [](Shot& s) {
        auto& screen = s.world.things[court_screen];
        screen.is_apart = true, screen.material.film = 0.3, screen.material.flickers = true, screen.material.glow = 0.8;
        s.part = Part::things;
    });
    add("zoom-untold", "vectors leave out that the lens becomes longer", "zoom", all.zoom,
        [](Shot& s) { s.vectors = Vectors::without_lens; }, true);
    add("shift-untold", "vectors leave out that the lens is shifted", "shift", all.shift,
        [](Shot& s) { s.vectors = Vectors::without_lens; });
    add("deformation", "vectors leave out that a ball grows and shrinks", "breathing", all.breathing, [](Shot& s) {
        s.world.things[court_ball].is_apart = true, s.vectors = Vectors::rigid, s.part = Part::things;
    });
    add("particles", "vectors are 0 for drops before the sky", "drops", all.drops,
        [](Shot& s) { s.vectors = Vectors::apart_zero, s.part = Part::things; }, true);
    add("things-still", "vectors leave out that things move", "fast", all.fast,
        [](Shot& s) { s.vectors = Vectors::things_still, s.part = Part::things; });
    add("reflections", "a floor and a screen mirror what moves", "court", all.court, [](Shot& s) {
        for (auto const i : {court_floor, court_screen})
            s.world.things[i].is_apart = true, s.world.things[i].material.gloss = 0.75, s.world.things[i].material.roughness = 0.02;
        s.part = Part::things;
    });
    add("shadows", "the lamp moves, and shadows with it", "still", all.still, [](Shot& s) {
        s.world.lamp.speed = {0.35, 0., 0.1}, s.part = Part::shadows;
    });
    add("glow-moves", "a ball that sends out light has no vectors", "fast", all.fast, [](Shot& s) {
        s.world.things[court_ball].material.glow = 1.5, s.vectors = Vectors::apart_zero, s.part = Part::things;
    });
}

void add_wrong_vectors(std::vector<Situation>& list, Right const& all) {
    auto const add = [&](char const* name, char const* about, Vectors vectors, bool is_small = false) {
        list.push_back({name, about, but(all.court, [&](Shot& s) { s.vectors = vectors; }), "court", is_small});
    };
    add("vectors-mirrored", "vectors have the wrong sign in x", Vectors::mirrored);
    add("vectors-halved", "vectors are half as long", Vectors::halved);
    add("vectors-late", "vectors are those of the frame before", Vectors::late);
    add("vectors-zero", "vectors are 0", Vectors::zero);
}

/// Frames that say nothing new, and noise that pixels share.
void add_shared_noise(std::vector<Situation>& list, Right const& all) {
    auto const add = [&](char const* name, char const* about, char const* twin, Shot const& from, Change const& change, bool is_small = false) {
        list.push_back({name, about, but(from, change), twin, is_small});
    };
    add("held", "every frame is there twice", "court", all.court, [](Shot& s) { s.is_held = true; }, true);
    add("one-seed", "every frame has the same random numbers", "court", all.court, [](Shot& s) { s.has_one_seed = true; });
    add("frozen", "the same random numbers before a still camera", "fast", all.fast, [](Shot& s) { s.has_one_seed = true; });
    add("baked", "the light of two things has noise that goes with them", "court", all.court, [](Shot& s) {
        s.is_baked = true, s.part = Part::things;
        for (auto const i : {court_box, court_screen}) s.world.things[i].is_apart = true;
    });
    add("splatted", "each sample counts for 3x3 pixels", "court", all.court, [](Shot& s) { s.spread = Spread::splatted; }, true);
    add("blue", "the noise of neighbours is opposite", "court", all.court, [](Shot& s) { s.dither = Dither::blue; });
    add("doubled", "rendered at half the size, and each pixel written four times", "court", all.court,
        [](Shot& s) { s.spread = Spread::doubled; });
    add("denoised", "another denoiser was there before", "court", all.court, [](Shot& s) { s.spread = Spread::filtered; });
}

void add_wrong_numbers(std::vector<Situation>& list, Right const& all) {
    auto const add = [&](char const* name, char const* about, char const* twin, Change const& change, bool is_small = false) {
        list.push_back({name, about, but(all.court, change), twin, is_small});
    };
    add("samples-hundredfold", "the file says 100 times the samples", "court", [](Shot& s) { s.says = 100; }, true);
    add("samples-hundredth", "the file says a hundredth of the samples", "court", [](Shot& s) { s.says = 0.01; });
    add("samples-eightfold", "the file says 8 times the samples", "court", [](Shot& s) { s.says = 8; });
    add("time-limit", "the file says 4096 samples", "court", [](Shot& s) { s.says_at_least = 4096; });
    add("adaptive", "where a pixel shows one surface, an eighth of the samples", "court", [](Shot& s) { s.is_adaptive = true; });
    add("layers", "another view layer says 100 times the samples", "court", [](Shot& s) { s.has_layers = true; });
    list[list.size() - 2].samples = {16, 64}; // adaptive
}

void add_wrong_guides(std::vector<Situation>& list, Right const& all) {
    auto const add = [&](char const* name, char const* about, char const* twin, Shot const& from, Change const& change, bool is_small = false) {
        list.push_back({name, about, but(from, change), twin, is_small});
    };
    add("normals-zero", "normals are 0", "own", all.own, [](Shot& s) { s.faults.normal = Fault::zero; }, true);
    add("normals-noisy", "normals have noise", "own", all.own, [](Shot& s) { s.faults.normal = Fault::noisy; });
    add("normals-late", "normals are those of the frame before", "court", all.court,
        [](Shot& s) { s.faults.normal = Fault::of_frame_before; });
    add("depth-zero", "depth is 0", "own", all.own, [](Shot& s) { s.faults.depth = Fault::zero; });
    add("depth-noisy", "depth has noise", "court", all.court, [](Shot& s) { s.faults.depth = Fault::noisy; });
    add("depth-late", "depth is that of the frame before", "court", all.court, [](Shot& s) { s.faults.depth = Fault::of_frame_before; });
    add("albedo-zero", "albedo is 0", "own", all.own, [](Shot& s) { s.faults.albedo = Fault::zero; });
    add("albedo-noisy", "albedo has noise", "own", all.own, [](Shot& s) { s.faults.albedo = Fault::noisy; });
    add("albedo-late", "albedo is that of the frame before", "own", all.own, [](Shot& s) { s.faults.albedo = Fault::of_frame_before; });
    add("albedo-highlight", "the albedo of a rough metal is a highlight", "metal", all.metal,
        [](Shot& s) { s.faults.albedo = Fault::highlight, s.part = Part::things; }, true);
    add("half", "16 bits for each number", "court", all.court, [](Shot& s) { s.is_half = true; });
}

void add_other_light(std::vector<Situation>& list, Right const& all) {
    auto const add = [&](char const* name, char const* about, char const* twin, Shot const& from, Change const& change, bool is_small = false) {
        list.push_back({name, about, but(from, change), twin, is_small});
    };
    add("flames", "light over alpha 0", "court", all.court, [](Shot& s) {
        s.is_transparent = true, s.part = Part::flames;
        s.world.flames = {{{-1.2, 2., -1.6}, {1.6, 0.7, 0.15}, 0.7, {0., 0.03, 0.}}, {{0.9, 2.4, -3.}, {1.2, 0.4, 0.1}, 0.8, {0.02, 0.04, 0.}}};
    }, true);
    add("glass", "a pane stands before all on the right, whose guides it has", "court", all.court, [](Shot& s) {
        s.world.things.push_back({.shape = Shape::box, .at = {1.2, 1., 0.}, .half = {0.7, 0.9, 0.02}, .material = {.is_clear = true}, .is_apart = true});
        s.part = Part::things;
    });
    add("fog", "the light of a fog lies over all", "court", all.court, [](Shot& s) { s.world.fog = 0.08; });
    add("cut", "the camera jumps at frame 5, and vectors leave it out", "court", all.court,
        [](Shot& s) { s.path = Path::cuts, s.vectors = Vectors::without_cut; });
    add("flash", "the lamp is six times as bright in frame 5", "court", all.court,
        [](Shot& s) { s.world.exposure = {.flash = 5, .flashes = 6}; }, true);
    add("fade", "each frame has two thirds of the light", "court", all.court, [](Shot& s) { s.world.exposure.grows = 0.67; });
    add("exposure", "each frame has 1.3 times the light", "court", all.court, [](Shot& s) { s.world.exposure.grows = 1.3; });
}

} // namespace

std::vector<Situation> situations() {
    Right const all;
    std::vector<Situation> list;
    add_right(list, all);
    add_untold_motion(list, all);
    add_wrong_vectors(list, all);
    add_shared_noise(list, all);
    add_wrong_numbers(list, all);
    add_wrong_guides(list, all);
    add_other_light(list, all);
    return list;
}

} // namespace quell::gauntlet
