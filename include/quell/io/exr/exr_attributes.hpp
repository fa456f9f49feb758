#pragma once

#include <quell/io/exr_image.hpp>

#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <glm/gtc/type_ptr.hpp>

#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET::io::detail {

template <class Matrix> glm::mat4 matrix_from(Matrix const& m) {
    glm::mat4 result;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) result[i][j] = static_cast<float>(m.x[i][j]);
    return result;
}
inline Imath::M44f matrix_for_file(glm::mat4 const& m) {
    Imath::M44f result;
    std::copy_n(glm::value_ptr(m), 16, &result.x[0][0]);
    return result;
}

/// Empty for a type that Attribute does not have.
inline std::optional<Attribute> attribute_from(Imf::Attribute const& a) {
    if (auto const* const text = dynamic_cast<Imf::StringAttribute const*>(&a)) return text->value();
    if (auto const* const whole = dynamic_cast<Imf::IntAttribute const*>(&a)) return whole->value();
    if (auto const* const number = dynamic_cast<Imf::FloatAttribute const*>(&a)) return number->value();
    if (auto const* const wide = dynamic_cast<Imf::DoubleAttribute const*>(&a)) return static_cast<float>(wide->value());
    if (auto const* const pair = dynamic_cast<Imf::V2fAttribute const*>(&a)) return glm::vec2(pair->value().x, pair->value().y);
    if (auto const* const m = dynamic_cast<Imf::M44fAttribute const*>(&a)) return matrix_from(m->value());
    if (auto const* const m = dynamic_cast<Imf::M44dAttribute const*>(&a)) return matrix_from(m->value());
    return std::nullopt;
}

/// Of attributes with the same name in several parts, the first counts.
inline void copy_attributes(Imf::Header const& header, std::map<std::string, Attribute, std::less<>>& into) {
    for (auto i = header.begin(); i != header.end(); ++i)
        if (auto const value = attribute_from(i.attribute())) into.emplace(i.name(), *value);
}

inline void insert_attribute(Imf::Header& header, std::string const& name, Attribute const& value) {
    if (auto const* const text = std::get_if<std::string>(&value)) header.insert(name, Imf::StringAttribute(*text));
    if (auto const* const whole = std::get_if<int>(&value)) header.insert(name, Imf::IntAttribute(*whole));
    if (auto const* const number = std::get_if<float>(&value)) header.insert(name, Imf::FloatAttribute(*number));
    if (auto const* const v = std::get_if<glm::vec2>(&value)) header.insert(name, Imf::V2fAttribute({v->x, v->y}));
    if (auto const* const m = std::get_if<glm::mat4>(&value)) header.insert(name, Imf::M44fAttribute(matrix_for_file(*m)));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io::detail
