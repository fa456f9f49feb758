#include <gauntlet/situation_list.hpp>
#include <gauntlet/worlds.hpp>

namespace quell::gauntlet {

namespace {

Shot shot_of(World world, Path path = Path::dolly) { return {.world = std::move(world), .path = path}; }

/// Those in which all is as it should be.
void add_right(SituationList& list) {
    list.add_right("court", "the camera goes sideways", shot_of(court()), true);
    list.add_right("still", "the camera stands", shot_of(court(), Path::still));
    list.add_right("turning", "the camera turns, and vectors say so of the sky", shot_of(court(), Path::turns));
    list.add_right("zoom", "the lens becomes longer, and vectors say so", shot_of(plain_court(), Path::zooms));
    list.add_right("shift", "the lens is shifted, and vectors say so", shot_of(plain_court(), Path::shifts));
    list.add_right("drops", "drops fly before the sky", shot_of(drops()));
    list.add_right("breathing", "a ball grows and shrinks, and vectors say so",
                   list.with("court", [](Shot& s) { s.world.things[court_ball].breath = 0.25; }));
    list.add_right("fast", "a ball rolls and a box turns before a still camera", list.with("still", [](Shot& s) {
        auto &ball = s.world.things[court_ball], &box = s.world.things[court_box];
        ball.is_apart = box.is_apart = true, ball.speed = {0.09, 0., 0.01}, box.spin = 0.04;
    }));
    auto own = shot_of(plain_court());
    own.names = Names::own, own.says = 0;
    list.add_right("own", "a picture with an albedo, in files that do not say how many samples", own);
    list.add_right("own-says", "a picture with an albedo, in files that say how many samples",
                   list.with("own", [](Shot& s) { s.says = 1; }));
    list.add_right("metal", "a rough metal ball with an albedo", list.with("own-says", [](Shot& s) {
        auto& ball = s.world.things[court_ball];
        ball.is_apart = true, ball.material.gloss = 0.9, ball.material.roughness = 0.4;
    }));
}

void add_wrong_vectors(SituationList& list) {
    auto const add = [&](char const* name, char const* about, Vectors vectors) {
        list.add(name, about, "history", "court", [&](Shot& s) { s.vectors = vectors; });
    };
    add("vectors-mirrored", "vectors have the wrong sign in x", Vectors::mirrored);
    add("vectors-halved", "vectors are half as long", Vectors::halved);
    add("vectors-late", "vectors are those of the frame before", Vectors::late);
    add("vectors-zero", "vectors are 0", Vectors::zero);
    list.add("cut", "the camera jumps at frame 5, where vectors are 0", "history", "court",
             [](Shot& s) { s.path = Path::cuts, s.vectors = Vectors::cut_zero; });
}

/// Frames that say nothing new, and noise that pixels share.
void add_shared_noise(SituationList& list) {
    auto const held = [](Shot& s) { s.is_held = true; };
    auto const splatted = [](Shot& s) { s.spread = Spread::splatted; };
    list.add("held", "every frame is there twice", "light that comes back", "court", held, true);
    list.add("held-own", "every frame is there twice, in files that do not say how many samples", "light that comes back", "own", held);
    list.add("one-seed", "every frame has the same random numbers", "light that comes back", "court",
             [](Shot& s) { s.has_one_seed = true; });
    list.add("frozen", "the same random numbers before a still camera", "light that comes back", "fast",
             [](Shot& s) { s.has_one_seed = true; });
    list.add("baked", "the light of two things has noise that goes with them", "light that comes back", "court", [](Shot& s) {
        s.is_baked = true, s.part = Part::things;
        for (auto const i : {court_box, court_screen}) s.world.things[i].is_apart = true;
    });
    list.add("splatted", "each sample counts for 3x3 pixels", "residual feedback", "court", splatted, true);
    list.add("splatted-own", "each sample counts for 3x3 pixels, in files that do not say how many", "light that comes back", "own",
             splatted);
    list.add("blue", "the noise of neighbours is opposite", "residual feedback", "court", [](Shot& s) { s.dither = Dither::blue; });
    list.add("doubled", "rendered at half the size, and each pixel written four times", "residual feedback", "court",
             [](Shot& s) { s.spread = Spread::doubled; });
    list.add("denoised", "another denoiser was there before", "residual feedback", "court", [](Shot& s) { s.spread = Spread::filtered; });
}

void add_wrong_numbers(SituationList& list) {
    auto const add = [&](char const* name, char const* about, Change const& change, bool is_small = false) {
        list.add(name, about, "number of samples", "court", change, is_small);
    };
    add(
        "samples-hundredfold", "the file says 100 times the samples", [](Shot& s) { s.says = 100; }, true);
    add("samples-eightfold", "the file says 8 times the samples", [](Shot& s) { s.says = 8; });
    add("samples-hundredth", "the file says a hundredth of the samples", [](Shot& s) { s.says = 0.01; });
    add("time-limit", "the file says 4096 samples", [](Shot& s) { s.says_at_least = 4096; });
    add("layers", "another view layer says 100 times the samples", [](Shot& s) { s.has_layers = true; });
    add("adaptive", "where a pixel shows one surface, an eighth of the samples", [](Shot& s) { s.is_adaptive = true; });
    list.last().samples = {16, 64};
}

void add_wrong_guides(SituationList& list) {
    auto const add = [&](char const* name, char const* about, char const* twin, Fault Faults::*guide, Fault fault, bool is_small = false) {
        list.add(
            name, about, "guides", twin, [&](Shot& s) { s.faults.*guide = fault; }, is_small);
    };
    add("normals-zero", "normals are 0", "own", &Faults::normal, Fault::zero);
    add("normals-zero-says", "normals are 0, and the file says how many samples", "own-says", &Faults::normal, Fault::zero, true);
    add("normals-noisy", "normals have noise", "own-says", &Faults::normal, Fault::noisy);
    add("normals-late", "normals are those of the frame before", "court", &Faults::normal, Fault::of_frame_before);
    add("depth-zero", "depth is 0", "own", &Faults::depth, Fault::zero);
    add("depth-noisy", "depth has noise", "court", &Faults::depth, Fault::noisy);
    add("depth-late", "depth is that of the frame before", "court", &Faults::depth, Fault::of_frame_before);
    add("albedo-zero", "albedo is 0", "own", &Faults::albedo, Fault::zero);
    add("albedo-noisy", "albedo has noise", "own-says", &Faults::albedo, Fault::noisy);
    add("albedo-late", "albedo is that of the frame before", "own", &Faults::albedo, Fault::of_frame_before);
    auto const add_highlight = [&](char const* name, char const* about, Fault fault, bool is_small) {
        list.add(
            name, about, "guides", "metal", [&](Shot& s) { s.faults.albedo = fault, s.part = Part::things; }, is_small);
    };
    add_highlight("albedo-highlight", "the albedo of a rough metal is a highlight", Fault::highlight, false);
    add_highlight("albedo-white", "the albedo of a rough metal is a highlight, cut to 1", Fault::white, true);
    list.add("half", "16 bits for each number", "guides", "court", [](Shot& s) { s.is_half = true; });
}

void add_other_light(SituationList& list) {
    list.add(
        "flames", "light over alpha 0", "alpha", "court",
        [](Shot& s) {
            s.is_transparent = true, s.part = Part::flames;
            s.world.flames = {{{-1.2, 2., -1.6}, {1.6, 0.7, 0.15}, 0.7, {0., 0.03, 0.}},
                              {{0.9, 2.4, -3.}, {1.2, 0.4, 0.1}, 0.8, {0.02, 0.04, 0.}}};
        },
        true);
    list.add("glass", "a pane on the right, whose guides all has that stands behind it", "guides", "court", [](Shot& s) {
        s.world.things.push_back(
            {.shape = Shape::box, .at = {1.2, 1., 0.}, .half = {0.7, 0.9, 0.02}, .material = {.is_clear = true}, .is_apart = true});
        s.part = Part::things;
    });
    list.add("fog", "the light of a fog lies over all", "colours of frames around", "court", [](Shot& s) { s.world.fog = 0.08; });
    list.add("flash", "the lamp is six times as bright in frame 5", "history", "court",
             [](Shot& s) { s.world.exposure = {.flash = 5, .flashes = 6}; });
    list.add("fade", "each frame has two thirds of the light", "history", "court", [](Shot& s) { s.world.exposure.grows = 0.67; });
    list.add("exposure", "each frame has 1.3 times the light", "history", "court", [](Shot& s) { s.world.exposure.grows = 1.3; });
}

} // namespace

std::vector<Situation> situations() {
    SituationList list;
    add_right(list);
    add_untold_motion(list);
    add_wrong_vectors(list);
    add_shared_noise(list);
    add_wrong_numbers(list);
    add_wrong_guides(list);
    add_other_light(list);
    return list.all;
}

} // namespace quell::gauntlet
