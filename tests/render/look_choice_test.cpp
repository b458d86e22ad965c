// The choice between the fast and the rich look.
#include <QtTest>

#include "render/look_choice.h"

using namespace trundle;

class LookChoiceTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theRendererDecides_data() {
        QTest::addColumn<QString>("renderer");
        QTest::addColumn<bool>("software");
        for (const char* name :
             {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Software Rasterizer", "swrast", "SWR (LLVM 11.0, 256 bits)",
              "Google SwiftShader", "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (LLVM 10.0.0)), SwiftShader driver)",
              "zink Vulkan 1.3 (llvmpipe (LLVM 15.0.6, 256 bits))", "D3D12 (Microsoft Basic Render Driver)", ""})
            QTest::newRow(*name ? name : "none") << name << true;
        for (const char* name :
             {"Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "AMD Radeon RX 6700 XT (navi22, LLVM 15.0.6, DRM 3.49)",
              "NVIDIA GeForce RTX 3060/PCIe/SSE2", "virgl (Mesa Intel(R) Xe Graphics)", "SVGA3D; build: RELEASE; LLVM;",
              "D3D12 (NVIDIA GeForce RTX 3060)", "Apple M2"})
            QTest::newRow(name) << name << false;
    }
    void theRendererDecides() {
        QFETCH(QString, renderer);
        QFETCH(bool, software);
        const std::string name = renderer.toStdString();
        QCOMPARE(isSoftwareRenderer(name), software);
        QCOMPARE(isRich(LookChoice::Automatic, name), !software);
        QVERIFY(isRich(LookChoice::Rich, name));
        QVERIFY(!isRich(LookChoice::Fast, name));
    }
};

QTEST_APPLESS_MAIN(LookChoiceTest)
#include "look_choice_test.moc"
