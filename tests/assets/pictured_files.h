#pragma once
// Mesh files with textures, as text.

#include <QByteArray>

namespace trundle {

/// A triangle with a texture; in GLB the texture is embedded.
inline QByteArray daeWith(const QByteArray& picture) {
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_images><image id="im"><init_from>)" +
           picture + R"(</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON><newparam sid="sf"><surface type="2D"><init_from>im</init_from></surface></newparam>
<newparam sid="ss"><sampler2D><source>sf</source></sampler2D></newparam><technique sid="t"><lambert><diffuse>
<texture texture="ss" texcoord="UV"/></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m" name="paint"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><source id="u"><float_array id="ua" count="6">0 0 1 0 0 1</float_array>
<technique_common><accessor source="#ua" count="3" stride="2"><param name="S" type="float"/><param name="T" type="float"/>
</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1" material="ms"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="TEXCOORD" source="#u" offset="0" set="0"/>
<p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="ms" target="#m"><bind_vertex_input semantic="UV" input_semantic="TEXCOORD" input_set="0"/></instance_material>
</technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// Positions of a triangle, then its texture coordinates, counted from the top as in glTF.
inline QByteArray gltfNumbers() {
    const float numbers[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 0};
    return QByteArray(reinterpret_cast<const char*>(numbers), sizeof numbers);
}

/// `images`: content of the array of images; `buffer`: properties of the buffer besides its length.
inline QByteArray gltfWith(const QByteArray& image, const QByteArray& buffer, qsizetype bytes, const QByteArray& views = {}) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":
{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],"materials":[{"name":"paint","pbrMetallicRoughness":{"baseColorFactor":[0.25,0.25,0.25,1],
"baseColorTexture":{"index":0},"roughnessFactor":0.25}}],"textures":[{"source":0}],"images":[)" +
           image + R"(],"buffers":[{)" + buffer + R"("byteLength":)" + QByteArray::number(bytes) +
           R"(}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24})" + views +
           R"(],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5126,
"count":3,"type":"VEC2"}]})";
}

inline QByteArray littleEndian(qsizetype number) {
    const auto value = static_cast<std::uint32_t>(number);
    return QByteArray(reinterpret_cast<const char*>(&value), 4);
}

inline QByteArray glbWith(QByteArray picture) {
    while (picture.size() % 4) picture += '\0';
    const QByteArray numbers = gltfNumbers();
    QByteArray text = gltfWith(R"({"bufferView":2,"mimeType":"image/png"})", "", numbers.size() + picture.size(),
                               R"(,{"buffer":0,"byteOffset":60,"byteLength":)" + QByteArray::number(picture.size()) + "}");
    while (text.size() % 4) text += ' ';
    const QByteArray content = numbers + picture;
    return QByteArray("glTF") + littleEndian(2) + littleEndian(12 + 8 + text.size() + 8 + content.size()) +
           littleEndian(text.size()) + "JSON" + text + littleEndian(content.size()) + QByteArray("BIN\0", 4) + content;
}

inline QByteArray gltfImage(const QByteArray& uri) { return "{\"uri\":\"" + uri + "\"}"; }

} // namespace trundle
