#include "scenes.hpp"
namespace quell::tracer { SceneDescription temple() { return room(); } }
