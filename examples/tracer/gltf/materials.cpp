#include "parts.hpp"

#include <map>
#include <utility>

namespace quell::tracer::gltf {
namespace {

Wrap wrap_of(int code) {
    if (code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
    return code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror : Wrap::repeat;
}

/// Four components of 8 bits, whatever the image has.
glm::u8vec4 texel_of(tinygltf::Image const& image, std::size_t i) {
    auto const components = static_cast<std::size_t>(image.component), bytes = static_cast<std::size_t>(image.bits / 8);
    auto const component = [&](std::size_t j) { return image.image[(i * components + j) * bytes + bytes - 1]; };
    if (components < 3) return {component(0), component(0), component(0), components == 2 ? component(1) : 255};
    return {component(0), component(1), component(2), components == 4 ? component(3) : 255};
}

std::string name_of(tinygltf::Image const& image) { return image.uri.empty() ? image.name : image.uri; }

void check_image(Model const& model, tinygltf::Image const& image) {
    auto const pixels = static_cast<std::size_t>(std::max(image.width, 0)) * static_cast<std::size_t>(std::max(image.height, 0));
    bool const known = image.component >= 1 && image.component <= 4 && (image.bits == 8 || image.bits == 16);
    if (pixels == 0 || !known || image.image.size() < pixels * static_cast<std::size_t>(image.component * image.bits / 8))
        throw model.error("its texture '" + name_of(image) + "' is missing or can't be decoded",
                          "put that image file beside it, as PNG or JPEG");
}

/// Adds textures when a material first asks for them: the encoding depends on what it's used for.
class Textures {
public:
    Textures(Model const& model_, SceneDescription& scene_) : model(model_), scene(scene_) {}

    int use(int texture, Encoding encoding) {
        if (texture < 0) return -1;
        auto const [place, is_new] = numbers.try_emplace({texture, encoding}, static_cast<int>(scene.textures.size()));
        if (is_new) scene.add(read(texture, encoding));
        return place->second;
    }

private:
    [[nodiscard]] Texture read(int number, Encoding encoding) const {
        auto const& source = model.item(model.content.textures, number, "texture");
        auto const& image = model.item(model.content.images, source.source, "image");
        check_image(model, image);
        std::vector<glm::u8vec4> texels(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
        for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = texel_of(image, i);
        Texture texture{image.width, image.height, std::move(texels), encoding};
        if (source.sampler < 0) return texture;
        auto const& sampler = model.item(model.content.samplers, source.sampler, "sampler");
        texture.wrap_u = wrap_of(sampler.wrapS);
        texture.wrap_v = wrap_of(sampler.wrapT);
        return texture;
    }

    Model const& model;
    SceneDescription& scene;
    std::map<std::pair<int, Encoding>, int> numbers;
};

glm::vec3 colour_of(std::vector<double> const& values, glm::vec3 otherwise) {
    return values.size() < 3 ? otherwise : glm::vec3{values[0], values[1], values[2]};
}

float emissive_strength(tinygltf::Material const& material) {
    auto const extension = material.extensions.find("KHR_materials_emissive_strength");
    if (extension == material.extensions.end() || !extension->second.Has("emissiveStrength")) return 1;
    return static_cast<float>(extension->second.Get("emissiveStrength").GetNumberAsDouble());
}

Material material_of(tinygltf::Material const& source, Textures& textures) {
    auto const& surface = source.pbrMetallicRoughness;
    Material material;
    material.base = colour_of(surface.baseColorFactor, glm::vec3{1.f});
    material.metallic = static_cast<float>(surface.metallicFactor);
    material.roughness = static_cast<float>(surface.roughnessFactor);
    material.emission = colour_of(source.emissiveFactor, glm::vec3{0.f}) * emissive_strength(source);
    material.emits_both_sides = source.doubleSided;
    // What is blended becomes a mask: half transparent is as good as opaque for finding the first surface.
    if (source.alphaMode != "OPAQUE") material.alpha_cutoff = source.alphaMode == "MASK" ? static_cast<float>(source.alphaCutoff) : 0.5f;
    material.base_texture = textures.use(surface.baseColorTexture.index, Encoding::srgb);
    material.metallic_roughness_texture = textures.use(surface.metallicRoughnessTexture.index, Encoding::linear);
    material.emission_texture = textures.use(source.emissiveTexture.index, Encoding::srgb);
    return material;
}

} // namespace

void add_materials(Model const& model, SceneDescription& scene) {
    Textures textures{model, scene};
    for (auto const& material : model.content.materials) scene.add(material_of(material, textures));
    scene.add(Material{});
}

} // namespace quell::tracer::gltf
