// Measures the delay from a key press to the updated tree and view, and from filter text to the filtered tree.

#include <QLineEdit>
#include <QTreeView>

#include "bench/window/bench_window.h"
#include "editor/outline/outline_model.h"
#include "editor/outline/outline_panel.h"
#include "editor/text/code/code_edit.h"
#include "editor/viewport/view/view.h"

namespace trundle {
namespace {

BenchApplication& application() { return *static_cast<BenchApplication*>(qApp); }

/// Records when the document changed and when the view showed the change.
struct Followed {
    explicit Followed(BenchWindow& w) : w(w) {
        m_connections[0] = QObject::connect(&w.window->document(), &Document::changed, [this] { changedAt = nowMs(); });
        m_connections[1] = QObject::connect(&w.view().image(), &ViewImage::shown, [this] {
            if (changedAt > 0 && drawnAt == 0 && this->w.view().image().isUpToDate()) drawnAt = nowMs();
        });
    }
    ~Followed() {
        for (const auto& connection : m_connections) QObject::disconnect(connection);
    }
    void begin() { changedAt = drawnAt = 0; }
    [[nodiscard]] bool viewShows() const { return drawnAt > 0 && application().paintedAt(w.view()) > drawnAt; }
    [[nodiscard]] bool treeShows() const { return changedAt > 0 && application().paintedAt(*w.tree().viewport()) > changedAt; }

    BenchWindow& w;
    double changedAt = 0, drawnAt = 0;
    QMetaObject::Connection m_connections[2];
};

/// Moves the caret behind the first `text`.
void putCaretBehind(BenchWindow& w, std::string_view text) {
    const std::string bytes = w.text().bytes();
    const auto at = std::uint32_t(bytes.find(text) + text.size());
    w.text().setFocus();
    w.text().select({at, at});
    w.wait(200);
    w.untilSettled();
}

/// Waits between keys with varying delays, as a person types.
void rest(BenchWindow& w, int key) { w.wait(120 + key * 37 % 200); }

} // namespace

QJsonObject measureTyping(const QString& file, int keys) {
    BenchWindow w;
    w.open(file);
    const auto lines = qint64(std::ranges::count(w.text().bytes(), '\n'));
    Followed followed(w);

    // A longer name changes the tree and the labels in the view; every other key deletes the letter again.
    std::vector<double> names, places, changed, busy, all;
    putCaretBehind(w, "Robot middle");
    const OutlineModel& model = w.window->findChild<OutlinePanel*>()->model();
    for (int i = 0; i < keys; ++i) {
        followed.begin();
        (void)application().takeLongest();
        const double begin = nowMs(), computed = computedByAllMs();
        if (i % 2 == 0) w.key(w.text(), Qt::Key_X, QStringLiteral("x"));
        else w.key(w.text(), Qt::Key_Backspace, {});
        w.until("tree and view show a name", [&] { return followed.viewShows() && followed.treeShows(); });
        names.push_back(std::max(application().paintedAt(w.view()), application().paintedAt(*w.tree().viewport())) - begin);
        changed.push_back(followed.changedAt - begin);
        busy.push_back(application().takeLongest().busyMs);
        all.push_back(computedByAllMs() - computed);
        const std::string name = i % 2 == 0 ? "middlex" : "middle";
        if (!const_cast<OutlineModel&>(model).indexOf(name).isValid()) qFatal("the tree has no %s", name.c_str());
        rest(w, i);
    }
    // A digit of its position moves it in the view.
    putCaretBehind(w, "Pos=0.0");
    for (int i = 0; i < keys; ++i) {
        followed.begin();
        const double begin = nowMs();
        if (i % 2 == 0) w.key(w.text(), Qt::Key_5, QStringLiteral("5"));
        else w.key(w.text(), Qt::Key_Backspace, {});
        w.until("the view shows a place", [&] { return followed.viewShows(); });
        places.push_back(application().paintedAt(w.view()) - begin);
        rest(w, i);
    }
    return {{QStringLiteral("lines"), lines},
            {QStringLiteral("robots"), qint64(w.window->document().loaded()->experiment->robots.size())},
            {QStringLiteral("changed"), summary(changed)}, // until the document has changed
            {QStringLiteral("busy"), summary(busy)},       // the longest event of each key
            {QStringLiteral("all"), summary(all)},         // processor time of all threads for each key
            {QStringLiteral("name"), summary(names)},
            {QStringLiteral("place"), summary(places)}};
}

QJsonObject measureFilter(const QString& file, int rounds) {
    BenchWindow w;
    w.open(file);
    auto& model = const_cast<OutlineModel&>(w.window->findChild<OutlinePanel*>()->model());
    const std::function<void(const QModelIndex&)> unfold = [&](const QModelIndex& parent) {
        model.fetchMore(parent);
        for (int row = 0; row < model.rowCount(parent); ++row) unfold(model.index(row, 0, parent));
    };
    unfold({});
    const auto nodes = qint64(model.work().made);
    QLineEdit& filter = *w.window->findChild<QLineEdit*>(QStringLiteral("outlineFilter"));
    filter.setFocus();
    w.wait(100);
    std::vector<double> times;
    const QString words = QStringLiteral("leftwheel");
    for (int round = 0; round < rounds; ++round)
        for (int i = 0; i < 2 * words.size(); ++i) {
            const bool types = i < words.size();
            const double begin = nowMs();
            if (types) w.key(filter, 0, words.mid(i, 1));
            else w.key(filter, Qt::Key_Backspace, {});
            const QString wanted = words.left(types ? i + 1 : 2 * words.size() - 1 - i);
            w.until("the tree is filtered", [&] {
                return QString::fromStdString(model.filter()) == wanted && application().paintedAt(*w.tree().viewport()) > begin;
            });
            times.push_back(application().paintedAt(*w.tree().viewport()) - begin);
            rest(w, i);
        }
    return {{QStringLiteral("nodes"), nodes}, {QStringLiteral("filter"), summary(times)}};
}

} // namespace trundle
