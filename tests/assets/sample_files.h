#pragma once
// Small mesh files as text, with parameters for the part that a test varies.

#include <QDir>
#include <QFile>
#include <QString>

#include <cstring>
#include <string>
#include <vector>

namespace trundle {

inline std::string writeSample(const QString& folder, const QString& name, const QByteArray& bytes) {
    QFile file(folder + "/" + name);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("cannot write a sample file");
    return file.fileName().toStdString();
}

/// A binary STL whose header has the given triangle count and whose triangles come from `corners`.
inline QByteArray binaryStl(std::uint32_t count, const std::vector<float>& corners) {
    QByteArray bytes(80, '\0');
    bytes.append(reinterpret_cast<const char*>(&count), 4);
    for (std::size_t i = 0; i + 9 <= corners.size(); i += 9) {
        bytes.append(12, '\0');
        bytes.append(reinterpret_cast<const char*>(&corners[i]), 36);
        bytes.append(2, '\0');
    }
    return bytes;
}

/// One triangle (0,0,0) (1,0,0) (0,0,2) as geometry "g" under the given nodes.
inline QByteArray collada(const QByteArray& nodes, const QByteArray& library = {}, const QByteArray& upAxis = "Z_UP",
                          const QByteArray& meter = "1") {
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter=")" +
           meter + R"("/><up_axis>)" + upAxis + R"(</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 0 2</float_array>
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
)" + (library.isEmpty() ? QByteArray() : "<library_nodes>" + library + "</library_nodes>") +
           "<library_visual_scenes><visual_scene id=\"s\">" + nodes +
           "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";
}

/// One triangle (0,0,0) (1,0,0) (0,2,0) in a node moved by (0,5,0); its 36 bytes come from `uri`.
inline QByteArray gltf(const QByteArray& uri, const QByteArray& count = "3") {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[0,5,0]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"uri":")" +
           uri + R"(","byteLength":36}],
"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
           count + R"(,"type":"VEC3"}]})";
}

inline QByteArray gltfBuffer() {
    const float numbers[9] = {0, 0, 0, 1, 0, 0, 0, 2, 0};
    return QByteArray(reinterpret_cast<const char*>(numbers), sizeof numbers);
}

} // namespace trundle
