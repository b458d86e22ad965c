// Which triangles of a mesh are reversed, so that its outside is outside.
#include <QtTest>

#include "assets/mesh_orientation.h"
#include "base/mesh_appearance.h"

using namespace trundle;

namespace {

/// Adds a box from `low` to `high`, points that are there already are used again.
void addBox(TriangleMesh& mesh, std::array<double, 3> low, std::array<double, 3> high, bool isInsideOut = false) {
    std::array<std::uint32_t, 8> at{};
    for (std::size_t i = 0; i < 8; ++i) {
        const std::array<double, 3> p{i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]};
        const auto known = std::find(mesh.points.begin(), mesh.points.end(), p);
        at[i] = static_cast<std::uint32_t>(known - mesh.points.begin());
        if (known == mesh.points.end()) mesh.points.push_back(p);
    }
    const std::array<std::array<std::size_t, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& f : faces) {
        mesh.triangles.push_back({at[f[0]], at[f[1]], at[f[2]]});
        mesh.triangles.push_back({at[f[0]], at[f[2]], at[f[3]]});
        for (std::size_t i = mesh.triangles.size() - 2; isInsideOut && i < mesh.triangles.size(); ++i)
            std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
    }
}

TriangleMesh boxes(std::initializer_list<std::pair<std::array<double, 6>, bool>> all) {
    TriangleMesh mesh;
    for (const auto& [b, isInsideOut] : all) addBox(mesh, {b[0], b[1], b[2]}, {b[3], b[4], b[5]}, isInsideOut);
    return mesh;
}

TriangleMesh box(bool isInsideOut = false) { return boxes({{{-1, -1, 0, 1, 1, 0.5}, isInsideOut}}); }

/// Numbers of the triangles that differ.
QList<int> differences(const TriangleMesh& a, const TriangleMesh& b) {
    QList<int> found;
    for (std::size_t i = 0; i < a.triangles.size(); ++i)
        if (a.triangles[i] != b.triangles[i]) found << int(i);
    return found;
}

QList<int> numbers(int from, int to) {
    QList<int> all;
    for (int i = from; i < to; ++i) all << i;
    return all;
}

/// Which triangles are reversed; fails if something else was changed.
QList<int> reversedOf(const TriangleMesh& mesh) {
    TriangleMesh result = mesh;
    orientOutwards(result);
    const QList<int> reversed = differences(mesh, result);
    TriangleMesh expected = mesh;
    for (const int i : reversed) std::swap(expected.triangles[std::size_t(i)][1], expected.triangles[std::size_t(i)][2]);
    return result.points == mesh.points && result.triangles == expected.triangles ? reversed : QList<int>{-1};
}

} // namespace

class MeshOrientationTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void shellsThatAreInsideOutAreReversed_data() {
        QTest::addColumn<TriangleMesh>("mesh");
        QTest::addColumn<QList<int>>("expected");
        const auto row = [](const char* name, const TriangleMesh& mesh, const QList<int>& expected) {
            QTest::newRow(name) << mesh << expected;
        };
        const std::array<double, 6> here{0, 0, 0, 4, 4, 4}, there{10, 0, 0, 12, 2, 2}, inHere{1, 1, 1, 3, 3, 3},
            deep{1.5, 1.5, 1.5, 2, 2, 2}, touching{4, 4, 0, 6, 6, 4};
        row("a sound box", box(), {});
        row("a box inside out", box(true), numbers(0, 12));
        row("far from its origin", boxes({{{1e6, 1e6, 1e6, 1e6 + 0.25, 1e6 + 0.25, 1e6 + 0.25}, true}}), numbers(0, 12));
        const std::array<double, 6> far{1e6 + 0.1, 2e6 + 0.3, 3e6 + 0.7, 1e6 + 0.2, 2e6 + 0.6, 3e6 + 0.9};
        row("small and far from its origin", boxes({{far, false}}), {});
        row("small and far from its origin, inside out", boxes({{far, true}}), numbers(0, 12));
        row("two boxes", boxes({{here, false}, {there, false}}), {});
        row("two boxes inside out", boxes({{here, true}, {there, true}}), numbers(0, 24));
        row("the second of two", boxes({{here, false}, {there, true}}), numbers(12, 24));
        row("the first of two", boxes({{there, true}, {here, false}}), numbers(0, 12));
        row("a cavity", boxes({{here, false}, {inHere, true}}), {});
        row("a cavity, the whole inside out", boxes({{inHere, false}, {here, true}}), numbers(0, 24));
        row("a part in a cavity", boxes({{deep, false}, {here, false}, {inHere, true}}), {});
        row("a part in a cavity, the whole inside out", boxes({{here, true}, {inHere, false}, {deep, true}}), numbers(0, 36));
        row("a cavity, and another box inside out", boxes({{here, false}, {inHere, true}, {there, true}}), numbers(24, 36));
        row("a box in another one", boxes({{here, false}, {inHere, false}}), {});
        row("boxes with a common edge", boxes({{here, false}, {touching, false}}), {});
        row("boxes with a common edge, inside out", boxes({{here, true}, {touching, true}}), numbers(0, 24));
        // As much inside as outside, but for rounding.
        const std::array<double, 6> one{0, 0, 0, 0.3, 0.3, 0.3}, other{0.3, 0.3, 0, 0.6, 0.6, 0.3};
        row("boxes with a common edge, the first inside out", boxes({{one, true}, {other, false}}), {});
        row("boxes with a common edge, the second inside out", boxes({{one, false}, {other, true}}), {});
    }
    void shellsThatAreInsideOutAreReversed() {
        QFETCH(TriangleMesh, mesh);
        QFETCH(QList<int>, expected);
        QCOMPARE(reversedOf(mesh), expected);
    }

    /// In the bounding box of another shell, but not in the shell: in the corner that an L leaves free.
    void aPartBesideAnLIsNoCavity() {
        TriangleMesh mesh;
        mesh.points = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0},
                       {0, 0, 4}, {4, 0, 4}, {4, 1, 4}, {1, 1, 4}, {1, 4, 4}, {0, 4, 4}};
        for (std::uint32_t i = 0; i < 6; ++i) {
            const std::uint32_t k = (i + 1) % 6;
            mesh.triangles.push_back({i, k, k + 6});
            mesh.triangles.push_back({i, k + 6, i + 6});
        }
        for (const std::array<std::uint32_t, 3> t : {std::array{0u, 1u, 2u}, {0u, 2u, 3u}, {0u, 3u, 4u}, {0u, 4u, 5u}}) {
            mesh.triangles.push_back({t[0], t[2], t[1]});
            mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
        }
        QCOMPARE(reversedOf(mesh), QList<int>());
        addBox(mesh, {2, 2, 1}, {3, 3, 3}, true);
        QCOMPARE(reversedOf(mesh), numbers(20, 32));
    }

    /// Some triangles have their outside inside, whichever they are.
    void trianglesOfAShellAgree() {
        for (const unsigned wrong : {0x001u, 0x800u, 0x5a5u, 0xffeu}) {
            TriangleMesh mesh = box();
            QList<int> expected;
            for (int i = 0; i < 12; ++i) {
                if ((wrong >> i & 1) == 0) continue;
                std::swap(mesh.triangles[std::size_t(i)][1], mesh.triangles[std::size_t(i)][2]);
                expected << i;
            }
            QCOMPARE(reversedOf(mesh), expected);
        }
    }

    /// Surfaces without an inside.
    void othersStay_data() {
        QTest::addColumn<TriangleMesh>("mesh");
        TriangleMesh open = box(true), sheet, both, mixed, partition = box(true);
        open.triangles.pop_back();
        QTest::newRow("a box that lacks a triangle") << open;
        for (std::ptrdiff_t i = 0; i < 11; ++i) {
            TriangleMesh without = box(true);
            without.triangles.erase(without.triangles.begin() + i);
            QTest::addRow("a box that lacks triangle %td", i) << without;
        }
        sheet.points = {{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1, 0.2}};
        sheet.triangles = {{0, 2, 1}, {0, 3, 2}};
        QTest::newRow("a sheet that faces down") << sheet;
        both = sheet;
        both.triangles.insert(both.triangles.end(), {{0, 1, 2}, {0, 2, 3}});
        QTest::newRow("a sheet with two sides") << both;
        mixed = sheet;
        std::swap(mixed.triangles[0][1], mixed.triangles[0][2]);
        QTest::newRow("a sheet that is wound both ways") << mixed;
        addBox(partition, {-1, -1, 0.5}, {1, 1, 0.7}, true);
        partition.triangles.erase(partition.triangles.begin() + 12, partition.triangles.begin() + 14);
        QTest::newRow("boxes with a common face") << partition;
        TriangleMesh plane; // the real projective plane, of six points
        plane.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 1, 1}};
        plane.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                           {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
        QTest::newRow("a closed surface with one side") << plane;
    }
    void othersStay() {
        QFETCH(TriangleMesh, mesh);
        QCOMPARE(reversedOf(mesh), QList<int>());
    }

    /// A closed shell beside an open one.
    void anOpenShellIsNoHindrance() {
        TriangleMesh mesh = box(true);
        mesh.triangles.pop_back();
        addBox(mesh, {5, 0, 0}, {6, 1, 1}, true);
        QCOMPARE(reversedOf(mesh), numbers(11, 23));
    }

    /// Where shells of both kinds are too many to compare them, the mesh stays.
    void manyShellsTakeNoTime() {
        TriangleMesh mesh;
        for (std::uint32_t i = 0; i < 40'000; ++i) {
            const double x = i % 200, y = i / 200;
            mesh.points.insert(mesh.points.end(), {{x, y, 0}, {x + 0.5, y, 0}, {x, y + 0.5, 0}, {x, y, 0.5}});
            const std::uint32_t a = 4 * i, b = a + 1 + i % 2, c = a + 2 - i % 2, d = a + 3;
            mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {a, b, d}, {a, d, c}, {b, c, d}});
        }
        QCOMPARE(reversedOf(mesh), QList<int>());
        for (std::uint32_t i = 0; i < 40'000; i += 2)
            for (std::uint32_t k = 4 * i; k < 4 * i + 4; ++k) std::swap(mesh.triangles[k][1], mesh.triangles[k][2]);
        QCOMPARE(reversedOf(mesh).size(), 160'000); // all inside out: nothing to compare
    }

    void texturesStayOnTheirCorners() {
        TriangleMesh mesh = box(true);
        MeshAppearance look;
        look.materials.resize(1);
        look.material.assign(12, 0);
        for (std::size_t i = 0; i < 12; ++i) {
            const auto at = [&](std::size_t k) {
                const auto& p = mesh.points[mesh.triangles[i][k]];
                return std::array<float, 2>{float(p[0] + p[2]), float(p[1] - p[2])};
            };
            look.onPicture.push_back({at(0), at(1), at(2)});
        }
        mesh.look = std::make_shared<const MeshAppearance>(look);
        const std::shared_ptr<const MeshAppearance> before = mesh.look;
        orientOutwards(mesh);
        QVERIFY(mesh.look != before);
        QCOMPARE(before->onPicture, look.onPicture);
        for (std::size_t i = 0; i < 12; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& p = mesh.points[mesh.triangles[i][k]];
                QCOMPARE(mesh.look->onPicture[i][k], (std::array<float, 2>{float(p[0] + p[2]), float(p[1] - p[2])}));
            }
    }
};

QTEST_APPLESS_MAIN(MeshOrientationTest)
#include "mesh_orientation_test.moc"
