#include <gauntlet/situation_list.hpp>
#include <gauntlet/worlds.hpp>

namespace quell::gauntlet {

namespace {

void play_film(Shot& shot, double glow) {
    auto& screen = shot.world.things[court_screen];
    screen.is_apart = true, screen.material.film = 0.3, screen.material.flickers = true, screen.material.glow = glow;
    shot.part = Part::things;
}

void add_motion_of_the_picture(SituationList& list) {
    constexpr auto colours = "colours of frames around";
    list.add(
        "sky-turns", "vectors are 0 for the sky while the camera turns", colours, "turning",
        [](Shot& s) { s.vectors = Vectors::sky_zero, s.part = Part::sky; }, true);
    list.add("clouds", "the sky's pattern turns by itself", colours, "still",
             [](Shot& s) { s.world.sky.spin = 0.02, s.vectors = Vectors::rigid, s.part = Part::sky; });
    list.add(
        "zoom-untold", "vectors leave out that the lens becomes longer", "history", "zoom",
        [](Shot& s) { s.vectors = Vectors::without_lens; }, true);
    list.add("shift-untold", "vectors leave out that the lens is shifted", "history", "shift",
             [](Shot& s) { s.vectors = Vectors::without_lens; });
    list.add(
        "film", "a screen plays a film", colours, "court", [](Shot& s) { play_film(s, 0); }, true);
    list.add("glow-film", "a screen that sends out light plays a film", "emission of frames around", "court",
             [](Shot& s) { play_film(s, 0.8); });
    list.add("scroll", "a texture goes over a wall that stands", colours, "still", [](Shot& s) {
        s.world.things[court_screen].is_apart = true, s.world.things[court_screen].material.film = 0.35, s.part = Part::things;
    });
}

void add_motion_of_things(SituationList& list) {
    constexpr auto history = "history";
    list.add("deformation", "vectors leave out that a ball grows and shrinks", history, "breathing",
             [](Shot& s) { s.world.things[court_ball].is_apart = true, s.vectors = Vectors::rigid, s.part = Part::things; });
    list.add(
        "particles", "vectors are 0 for drops before the sky", "light that comes back", "drops",
        [](Shot& s) { s.vectors = Vectors::apart_zero, s.part = Part::things; }, true);
    list.add("things-still", "vectors leave out that things move", history, "fast",
             [](Shot& s) { s.vectors = Vectors::things_still, s.part = Part::things; });
    list.add("appears", "a box is there from frame 5 on, as if it had always been", history, "court",
             [](Shot& s) { s.world.things[court_box].is_apart = true, s.world.things[court_box].appears = 5, s.part = Part::shadows; });
    list.add("reflections", "a floor and a screen mirror what moves", history, "court", [](Shot& s) {
        for (auto const i : {court_floor, court_screen})
            s.world.things[i].is_apart = true, s.world.things[i].material.gloss = 0.75, s.world.things[i].material.roughness = 0.02;
        s.part = Part::things;
    });
    list.add("shadows", "the lamp moves, and shadows with it", history, "still", [](Shot& s) {
        s.world.lamp.speed = {0.35, 0., 0.1}, s.part = Part::shadows;
    });
    list.add(
        "glow-moves", "a ball that sends out light has no vectors", "emission of frames around", "fast",
        [](Shot& s) { s.world.things[court_ball].material.glow = 1.5, s.vectors = Vectors::apart_zero, s.part = Part::things; }, true);
}

} // namespace

void add_untold_motion(SituationList& list) { add_motion_of_the_picture(list), add_motion_of_things(list); }

} // namespace quell::gauntlet
