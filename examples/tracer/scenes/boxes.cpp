#include "scenes.hpp"
namespace quell::tracer { SceneDescription boxes() { return room(); } }
