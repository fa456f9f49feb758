#pragma once

#include "../scene.hpp"

#include <vector>

namespace quell::tracer {

/// A sky and a sun that shines from this direction, far away. `degrees`: how wide the sun is, and so how soft its shadows are; its light
/// is the same for all.
void add_daylight(SceneDescription& scene, glm::vec3 sun_direction, float degrees = 2.5f);

/// A column that stands on y = 0, 3.3 high.
[[nodiscard]] TriangleMesh column_mesh();

/// What towns are made of, for scenes outdoors. Materials and meshes are added to the scene once, whatever is built of them.
class Town {
public:
    explicit Town(SceneDescription& scene);

    /// A house with a pyramid for its roof, standing on y = 0. `style` chooses among a few facades.
    void add_house(glm::vec3 place, float degrees, glm::vec3 size, int style);
    void add_tree(glm::vec3 place, float height);

private:
    SceneDescription& town;
    int wall, roof, trunk, crown;
    std::vector<int> facades;
    int shingles, bark, leaves;
};

} // namespace quell::tracer
