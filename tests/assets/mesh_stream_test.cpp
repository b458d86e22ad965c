// The binary stream of meshes and height maps between the reader process and the program.
#include <QtTest>

#include <cmath>
#include <limits>

#include "assets/mesh_stream.h"

using namespace trundle;

namespace {

TriangleMesh tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

void put(std::string& bytes, std::size_t at, auto value) { std::memcpy(bytes.data() + at, &value, sizeof value); }

} // namespace

class MeshStreamTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void decodesWhatWasEncoded() {
        const auto mesh = decodeMesh(encodeMesh(tetrahedron()));
        QVERIFY(mesh.ok());
        QVERIFY(mesh.value().points == tetrahedron().points);
        QVERIFY(mesh.value().triangles == tetrahedron().triangles);

        const HeightMap map{3, 2, {0, 0.5f, 1, 0.25f, 0, 1}};
        const auto back = decodeHeightMap(encodeHeightMap(map));
        QVERIFY(back.ok());
        QCOMPARE(back.value().columns, 3u);
        QVERIFY(back.value().heights == map.heights);
    }

    void everyShorterOrLongerStreamIsRefused() {
        const std::string whole = encodeMesh(tetrahedron());
        for (std::size_t size = 0; size < whole.size(); ++size) QVERIFY(!decodeMesh(whole.substr(0, size)).ok());
        QVERIFY(!decodeMesh(whole + '\0').ok());
        const std::string grey = encodeHeightMap({2, 2, {0, 0, 0, 0}});
        for (std::size_t size = 0; size < grey.size(); ++size) QVERIFY(!decodeHeightMap(grey.substr(0, size)).ok());
        QVERIFY(!decodeHeightMap(whole).ok());
        QVERIFY(!decodeMesh(grey).ok());
    }

    void rejectsInconsistentCounts_data() {
        QTest::addColumn<int>("lie");
        QTest::addColumn<QString>("word");
        QTest::newRow("4 thousand million points") << 0 << "too many";
        QTest::newRow("4 thousand million triangles") << 1 << "too many";
        QTest::newRow("an index one too large") << 2 << "not there";
        QTest::newRow("the largest index") << 3 << "not there";
        QTest::newRow("NaN") << 4 << "not a number";
        QTest::newRow("infinity") << 5 << "not a number";
        QTest::newRow("no triangle") << 6 << "no triangle";
    }
    void rejectsInconsistentCounts() {
        QFETCH(int, lie);
        QFETCH(QString, word);
        std::string bytes = encodeMesh(tetrahedron());
        const std::size_t lastIndex = bytes.size() - 4;
        switch (lie) {
        case 0: put(bytes, 8, 0xffffffffu); break;
        case 1: put(bytes, 12, 0xffffffffu); break;
        case 2: put(bytes, lastIndex, 4u); break;
        case 3: put(bytes, lastIndex, 0xffffffffu); break;
        case 4: put(bytes, 16, std::numeric_limits<double>::quiet_NaN()); break;
        case 5: put(bytes, 24, std::numeric_limits<double>::infinity()); break;
        default: bytes = encodeMesh({tetrahedron().points, {}}); break;
        }
        const auto mesh = decodeMesh(bytes);
        QVERIFY(!mesh.ok());
        QVERIFY2(QString::fromStdString(mesh.error().message).contains(word), mesh.error().message.c_str());
    }

    void heightsStayBetweenBlackAndWhite_data() {
        QTest::addColumn<float>("height");
        QTest::newRow("below") << -0.001f;
        QTest::newRow("above") << 1.001f;
        QTest::newRow("NaN") << std::numeric_limits<float>::quiet_NaN();
    }
    void heightsStayBetweenBlackAndWhite() {
        QFETCH(float, height);
        QVERIFY(!decodeHeightMap(encodeHeightMap({2, 2, {0, 0, 0, height}})).ok());
        QVERIFY(!decodeHeightMap(encodeHeightMap({1, 4, {0, 0, 0, 0}})).ok());
        QVERIFY(!decodeHeightMap(encodeHeightMap({65536, 65536, {}})).ok()); // the product of the sizes overflows 32 bits to 0
    }
};

QTEST_APPLESS_MAIN(MeshStreamTest)
#include "mesh_stream_test.moc"
