// The binary stream of meshes and height maps between the reader process and the program.
#include <QtTest>

#include <cmath>
#include <limits>

#include "assets/mesh_appearance_stream.h"
#include "assets/mesh_stream.h"
#include "assets/stream_limits.h"
#include "base/mesh_appearance.h"

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

    /// Materials with one picture, with another one and without; no value is that of another member.
    void appearanceIsDecodedAsItWasEncoded() {
        const auto wide = std::make_shared<const Raster>(Raster{3, 1, {1, 2, 3, 4, 5, 6, 7, 8, 9}});
        const auto high = std::make_shared<const Raster>(Raster{1, 2, {11, 12, 13, 14, 15, 16}});
        MeshAppearance look;
        look.materials = {{{0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f}, 0.7f, 0.8f, high},
                          {{0.9f, 0, 1}, {0, 1, 0}, 1, 0, nullptr},
                          {{1, 1, 1}, {0, 0, 0}, 0.25f, 0.75f, wide},
                          {{0, 0, 1}, {0, 0, 0}, 0.5f, 0.125f, high}};
        look.material = {3, 0, 2, 1};
        for (int i = 0; i < 4; ++i) {
            const auto at = static_cast<float>(i);
            look.onPicture.push_back({{{at, 0.5f}, {-1, at}, {1e6f, -1e6f}}});
        }
        look.warnings = {"no paint", "", "a picture is cut off"};
        TriangleMesh mesh = tetrahedron();
        mesh.look = std::make_shared<const MeshAppearance>(look);
        const auto decoded = decodeMesh(encodeMesh(mesh));
        QVERIFY(decoded.ok() && decoded.value().look);
        const MeshAppearance& is = *decoded.value().look;
        QVERIFY(is.material == look.material && is.onPicture == look.onPicture && is.warnings == look.warnings);
        QCOMPARE(is.materials.size(), look.materials.size());
        for (std::size_t i = 0; i < look.materials.size(); ++i) {
            const MeshMaterial &was = look.materials[i], &now = is.materials[i];
            QVERIFY(now.colour == was.colour && now.emission == was.emission);
            QVERIFY(now.opacity == was.opacity && now.shininess == was.shininess);
            QCOMPARE(bool(now.picture), bool(was.picture));
            if (!was.picture) continue;
            QVERIFY(now.picture->width == was.picture->width && now.picture->height == was.picture->height);
            QVERIFY(now.picture->pixels == was.picture->pixels);
        }
        QVERIFY(is.materials[0].picture == is.materials[3].picture); // stored once
    }

    void appearancesThatCannotBeAreRefused_data() {
        QTest::addColumn<int>("lie");
        QTest::addColumn<bool>("isRefused");
        const char* const names[] = {
            "as it should be",       "a material behind the last one", "a colour above 1",    "an opacity below 0",
            "a shininess above 1",   "a picture without coordinates",  "a coordinate of 2e6", "a coordinate that is no number",
            "a picture of no width", "a picture that is too wide",     "one byte more"};
        for (int lie = 0; lie < 11; ++lie) QTest::newRow(names[lie]) << lie << (lie > 0);
    }
    void appearancesThatCannotBeAreRefused() {
        QFETCH(int, lie);
        QFETCH(bool, isRefused);
        auto raster = std::make_shared<Raster>(Raster{2, 1, {1, 2, 3, 4, 5, 6}});
        MeshAppearance look;
        look.materials = {{{0.5f, 0.5f, 0.5f}, {0, 0, 0}, 1, 0, raster}, {}};
        look.material = {0, 1};
        look.onPicture.resize(2);
        const float huge = 2e6f, none = std::numeric_limits<float>::quiet_NaN();
        if (lie == 1) look.material[1] = 2;
        if (lie == 2) look.materials[1].colour[2] = 1.01f;
        if (lie == 3) look.materials[1].opacity = -0.01f;
        if (lie == 4) look.materials[0].shininess = 1.01f;
        if (lie == 5) look.onPicture.clear();
        if (lie == 6) look.onPicture[1][2][1] = huge;
        if (lie == 7) look.onPicture[1][2][0] = none;
        if (lie == 8) raster->width = 0, raster->pixels.clear();
        if (lie == 9) raster->width = kMaxRasterSide + 1, raster->pixels.resize((kMaxRasterSide + 1) * 3);
        const auto decoded = decodeAppearance(encodeAppearance(look) + (lie == 10 ? "x" : ""), 2);
        QCOMPARE(!decoded.ok(), isRefused);
    }

    void picturesKeepTheirSides() {
        const Raster raster{3, 2, std::vector<std::uint8_t>(18, 7)};
        const auto back = decodeRaster(encodeRaster(raster));
        QVERIFY(back.ok() && back.value().width == 3 && back.value().height == 2 && back.value().pixels == raster.pixels);
        const auto grey = decodeHeightMap(encodeHeightMap({3, 2, {0, 0.5f, 1, 0.25f, 0, 1}}));
        QVERIFY(grey.ok() && grey.value().columns == 3 && grey.value().rows == 2);
        const std::uint32_t most = kMaxRasterSide;
        QVERIFY(decodeRaster(encodeRaster({most, 1, std::vector<std::uint8_t>(most * 3)})).ok());
        QVERIFY(!decodeRaster(encodeRaster({most + 1, 1, std::vector<std::uint8_t>((most + 1) * 3)})).ok());
        QVERIFY(!decodeRaster(encodeRaster({1, most + 1, std::vector<std::uint8_t>((most + 1) * 3)})).ok());
        QVERIFY(!decodeHeightMap(encodeHeightMap({4, 1, {0, 0, 0, 0}})).ok());
        QVERIFY(!decodeHeightMap(encodeHeightMap({2, kMaxGreySide + 1, std::vector<float>(2 * (kMaxGreySide + 1))})).ok());
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
    /// What materials share is there once; limits of numbers, of warnings and of all pictures together.
    void limitsOfAppearances() {
        auto raster = std::make_shared<Raster>(Raster{2, 1, {1, 2, 3, 4, 5, 6}});
        MeshAppearance look;
        look.materials = {{{1, 0, 1}, {0, 1, 0}, 1, 0, raster}, {{0, 0, 0}, {0, 0, 0}, 0, 1, raster}};
        look.material = {0, 1};
        look.onPicture.resize(2);
        look.warnings = {std::string(kMaxWarningBytes, 'w')};
        const auto shared = decodeAppearance(encodeAppearance(look), 2);
        QVERIFY2(shared.ok(), shared.ok() ? "" : shared.error().message.c_str());
        QVERIFY(shared.value()->materials[0].picture == shared.value()->materials[1].picture);
        QCOMPARE(shared.value()->warnings[0].size(), std::size_t(kMaxWarningBytes));
        const auto isRefused = [](MeshAppearance other) {
            return !decodeAppearance(encodeAppearance(other), other.material.size()).ok();
        };
        MeshAppearance changed = look;
        changed.warnings[0] += "w";
        QVERIFY(isRefused(changed));
        for (const float emission : {1.01f, -0.01f}) {
            changed = look;
            changed.materials[1].emission[2] = emission;
            QVERIFY(isRefused(changed));
        }
        for (const float place : {-2e6f, 2e6f}) {
            changed = look;
            changed.onPicture[0][0][0] = place;
            QVERIFY(isRefused(changed));
        }
        changed = look;
        changed.warnings.assign(kMaxWarnings + 1, "");
        QVERIFY(isRefused(changed));
        changed.warnings.pop_back();
        QVERIFY(!isRefused(changed));
        changed = look;
        changed.materials.assign(kMaxMeshPictures + 1, look.materials[0]);
        for (auto& material : changed.materials) material.picture = std::make_shared<Raster>(*raster);
        QVERIFY(isRefused(changed));
        changed.materials.pop_back();
        QVERIFY(!isRefused(changed));
        for (const bool isWide : {true, false}) {
            changed = look;
            const std::uint32_t side = kMaxRasterSide + 1;
            changed.materials[0].picture =
                std::make_shared<Raster>(Raster{isWide ? side : 1, isWide ? 1 : side, std::vector<std::uint8_t>(side * 3)});
            QVERIFY(isRefused(changed));
        }
    }

    void picturesWithoutAPixelAreRefused() {
        QVERIFY(!decodeRaster(encodeRaster({0, 5, {}})).ok() && !decodeRaster(encodeRaster({5, 0, {}})).ok());
    }
};

QTEST_APPLESS_MAIN(MeshStreamTest)
#include "mesh_stream_test.moc"
