#include "app/imports/truth_page.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <exception>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/imports/truth_rows.h"
#include "app/shell/key_table.h"
#include "core/terrain/body_ceiling.h"
#include "widgets/base/card.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/plain_table.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr int kSaveAfter = 300;  // [ms] after the last decision
constexpr int kButtonsInARow = 6;
constexpr int kListCharacters = 44;  // width of the list

/// Adds a nudge to heights and slice.
void nudgeScene(TruthView::Scene& scene, const TruthDecision& nudge)
{
    for (SideTruth& side : scene.side)
        for (std::size_t i = 0; i < kBins; ++i)
            if (side.at(i).height)
                *side.at(i).height += nudge.nudgeAt(binCentre(static_cast<int>(i)));
    for (SlicePoint& point : scene.slice) point.z += nudge.nudgeAt(point.x);
}

}  // namespace

TruthPage::TruthPage(TruthFile file, QWidget* parent)
    : QWidget(parent), file_(std::move(file)), choices_(file_.truth())
{
    build();
    saveSoon_.setSingleShot(true);
    saveSoon_.setInterval(kSaveAfter);
    connect(&saveSoon_, &QTimer::timeout, this, &TruthPage::save);
    loadDecisions();
    showScene(choices_.nextOpen(file_.truth().scenes() - 1).value_or(0));
}

TruthPage::~TruthPage()
{
    try {
        save();
    } catch (const std::exception& error) {
        qWarning("the last decisions were not saved: %s", error.what());
    }
}

QPushButton* TruthPage::button(const QString& text, const QString& tip, void (TruthPage::*act)())
{
    auto* made = new QPushButton(text, this);
    setTip(*made, tip);
    made->setAccessibleName(tip);
    connect(made, &QPushButton::clicked, this, act);
    return made;
}

Card* TruthPage::makeList()
{
    rows_ = new TruthRows(file_.truth(), choices_, this);
    auto* list = new Card(tr("Scenes"), this);
    table_ = new QTableView(list);
    table_->setModel(rows_);
    table_->setAccessibleName(tr("Scenes"));
    setTip(*table_, tr("The arrow keys choose a scene; typing a number goes to it"));
    chooseRows(*table_);
    list->body()->addWidget(table_, 1);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) {
                if (now.isValid()) showScene(static_cast<std::size_t>(now.row()));
            });
    return list;
}

void TruthPage::makeButtons()
{
    accept_ = button(tr("&Accept"), tr("Keep the heights of this scene (A)"), &TruthPage::accept);
    exclude_ = button(tr("E&xclude"), tr("Leave this scene out (X)"), &TruthPage::exclude);
    undo_ = button(tr("&Undo"), tr("Take the last decision back (Ctrl+Z)"), &TruthPage::undo);
    export_ = button(tr("&Export …"), tr("Write the scenes with these decisions (Ctrl+E)"),
                     &TruthPage::askForExport);
    ahead_ = button(tr("2 cm ahead"), tr("Move the cloud ahead by 2 cm under the robot (K)"),
                    &TruthPage::moveAhead);
    back_ = button(tr("2 cm back"), tr("Move the cloud back by 2 cm under the robot (J)"),
                   &TruthPage::moveBack);
    deciding_ = {
        accept_,
        exclude_,
        button(tr("5 mm up"), tr("Move the heights up by 5 mm (U)"), &TruthPage::heightUp),
        button(tr("5 mm down"), tr("Move the heights down by 5 mm (D)"), &TruthPage::heightDown),
        button(tr("front up"), tr("Tilt by 0.005 rad: higher ahead (F)"), &TruthPage::tiltUp),
        button(tr("front down"), tr("Tilt by 0.005 rad: lower ahead (G)"), &TruthPage::tiltDown),
        ahead_,
        back_,
        button(tr("no nudge"), tr("Take the nudge of this scene away (0)"),
               &TruthPage::resetNudge)};
    for (QPushButton* const control : {ahead_, back_}) {
        control->setEnabled(file_.hasCells());
        if (!file_.hasCells()) setTip(*control, noCellsText());
    }
}

QLayout* TruthPage::makeControls(QWidget* parent)
{
    sides_ = new QComboBox(parent);
    sides_->addItems({tr("both sides"), tr("left side"), tr("right side")});
    sides_->setAccessibleName(tr("Shown sides"));
    sides_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);  // high as the buttons
    connect(sides_, &QComboBox::currentIndexChanged, this,
            [this](int index) { view_->setSides(static_cast<TruthView::Sides>(index)); });
    makeButtons();
    auto* buttons = new QGridLayout;
    int place = 0;
    QList<QWidget*> controls{accept_, exclude_, undo_, export_, sides_, deciding_.last()};
    for (QPushButton* const nudging : deciding_.mid(2, kButtonsInARow)) controls << nudging;
    for (QWidget* const control : controls) {
        buttons->addWidget(control, place / kButtonsInARow, place % kButtonsInARow);
        ++place;
    }
    return buttons;
}

Card* TruthPage::makeScene()
{
    auto* scene = new Card(tr("Slice of the cloud, robot and bins"), this);
    sceneText_ = new PlainLabel(scene);
    sceneText_->setWordWrap(true);
    sceneText_->setAccessibleName(tr("The scene"));
    view_ = new TruthView(scene);
    auto* key = new PlainLabel(
        file_.truth().isPlane
            ? tr("left: dots · right: crosses · bins: mean of both sides, ± 1 and 2 sd")
            : tr("left: dots, solid · right: crosses, dashed · bins with ± 1 and 2 sd"),
        scene);
    key->setWordWrap(true);
    auto* controls = makeControls(scene);
    scene->body()->addWidget(sceneText_);
    scene->body()->addWidget(view_, 1);
    scene->body()->addWidget(key);
    scene->body()->addLayout(controls);
    return scene;
}

void TruthPage::build()
{
    auto* list = makeList();
    auto* scene = makeScene();
    state_ = new PlainLabel(this);
    state_->setWordWrap(true);
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->setChildrenCollapsible(false);
    split->addWidget(list);
    split->addWidget(scene);
    split->setStretchFactor(1, 1);
    list->setMinimumWidth(fontMetrics().averageCharWidth() * kListCharacters);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    column->addWidget(split, 1);
    column->addWidget(state_);
    fitColumns();
    table_->viewport()->installEventFilter(this);
    table_->setFocus();
}

void TruthPage::fitColumns()
{
    fitRows(*table_, fontMetrics());
    const auto fit = [this](int column, const QStringList& texts) {
        int& width = widths_.at(static_cast<std::size_t>(column));
        width = columnWidthFor(*table_, fontMetrics(), column, texts);
        table_->setColumnWidth(column, width);
    };
    fit(TruthRows::Number, {QStringLiteral("10000")});
    const TruthDecision excluded{.kind = TruthDecision::Kind::Exclude}, accepted{};
    fit(TruthRows::Decision,
        {decisionText(nullptr), decisionText(&excluded), decisionText(&accepted)});
    fit(TruthRows::Drive, {QStringLiteral("10")});
    const TruthDecision nudged{.offset = -0.1, .tilt = -0.1};  // a longer one has a tip
    fit(TruthRows::Nudge, {nudgeText(&nudged)});
    sceneText_->setMinimumHeight(2 * fontMetrics().lineSpacing());
    fit(TruthRows::Cloud, {TruthRows::tr("%1 mm").arg(format::signedNumber(-100.0, 0))});
    fit(TruthRows::Known, {QStringLiteral("22")});
    fit(TruthRows::Time, {QStringLiteral("1000.0")});
    showColumnsThatFit();
}

void TruthPage::showColumnsThatFit()
{
    int left = table_->viewport()->width();
    for (int column = 0; column < TruthRows::kColumns; ++column) {
        left -= widths_.at(static_cast<std::size_t>(column));
        table_->setColumnHidden(column, left < 0 && column > TruthRows::Decision);
    }
}

bool TruthPage::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == table_->viewport() && event->type() == QEvent::Resize) showColumnsThatFit();
    return QWidget::eventFilter(watched, event);
}

void TruthPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (changesFont(*event) && table_) fitColumns();
}

void TruthPage::showState(const QString& text)
{
    state_->setText(summary() + QStringLiteral(" · ") + text);
}

QString TruthPage::summary() const
{
    return tr("%1 scenes: %2 accepted, %3 excluded")
        .arg(file_.truth().scenes())
        .arg(choices_.count(TruthDecision::Kind::Accept))
        .arg(choices_.count(TruthDecision::Kind::Exclude));
}

void TruthPage::showScene(std::size_t row)
{
    row_ = std::min(row, file_.truth().scenes() - 1);
    const int at = static_cast<int>(row_);
    if (table_->currentIndex().row() != at) table_->selectRow(at);
    showCurrent();
}

void TruthPage::showCurrent()
{
    const LaserTruth& truth = file_.truth();
    SceneTruth found = truth.truths[row_];
    const TruthDecision* const decision = choices_.decision(row_);
    const auto& readings = truth.tracks[row_].s;
    const auto& f = readings.flippers;
    TruthView::Scene shown{.outline = robotOutline(truth.robot, readings.pitch, 0.5 * (f[0] + f[1]),
                                                   0.5 * (f[2] + f[3])),
                           .slice = {},
                           .isPlane = truth.isPlane,
                           .isExcluded = decision && decision->kind == TruthDecision::Kind::Exclude,
                           .gap = {}};
    const Status seen = findScene(found, shown.slice, decision);
    shown.gap = seen ? gapText(found.gap) : translated(seen.error().message);
    shown.side = found.side;
    if (truth.isPlane) shown.side[0] = found.plane;
    if (decision) nudgeScene(shown, *decision);
    view_->setScene(std::move(shown));
    const QString nudge = nudgeText(decision);
    QStringList parts{
        tr("Scene %1 of %2").arg(row_ + 1).arg(truth.scenes()),
        tr("drive %1 at %2 s")
            .arg(format::shownName(truth.runOf(row_)), format::number(truth.timeOf(row_), 1)),
        tr("%1 bins known").arg(TruthRows::known(found, truth.isPlane))};
    if (found.contact)
        parts << tr("cloud %1 mm from the robot")
                     .arg(format::signedNumber(-1000.0 * found.contact->offset, 0));
    if (!nudge.isEmpty()) parts << tr("nudged by %1").arg(nudge);
    parts << decisionText(decision);
    sceneText_->setText(parts.join(QStringLiteral(" · ")));
    view_->setAccessibleDescription(sceneText_->text());
    undo_->setEnabled(choices_.canUndo());
}

Status TruthPage::findScene(SceneTruth& found, std::vector<SlicePoint>& slice,
                            const TruthDecision* decision)
{
    if (!decision || decision->cellsAlong() == 0 || !found.hasPlace()) {
        auto stored = file_.slice(row_);
        if (!stored) return stored.error();
        slice = *std::move(stored);
        return Done{};
    }
    auto grid = file_.grid(row_);
    if (!grid) return grid.error();
    sampleAlong(found, file_.truth(), *grid, 0, *decision);
    slice = truthSlice(*grid, file_.truth().robot, 0, found.correction);
    return Done{};
}

void TruthPage::go(int by)
{
    if (by < 0 && row_ == 0) return;
    showScene(by < 0 ? row_ - 1 : row_ + 1);
}

void TruthPage::addKeys(KeyTable& keys)
{
    const auto add = [&keys](QList<QKeyCombination> of, const QString& meaning,
                             std::function<void()> act, bool repeats = false) {
        keys.add({.keys = std::move(of),
                  .meaning = meaning,
                  .pressed = std::move(act),
                  .repeats = repeats});
    };
    keys.addGroup(tr("Scenes"));
    add(
        {Qt::Key_Period, Qt::Key_PageDown}, tr("next scene"), [this] { go(+1); }, true);
    add(
        {Qt::Key_Comma, Qt::Key_PageUp}, tr("previous scene"), [this] { go(-1); }, true);
    add({Qt::Key_N}, tr("next open scene"),
        [this] { showScene(choices_.nextOpen(row_).value_or(row_)); });
    add({QKeyCombination(Qt::ALT, Qt::Key_B)}, tr("show both sides"),
        [this] { sides_->setCurrentIndex(0); });
    add({QKeyCombination(Qt::ALT, Qt::Key_L)}, tr("show the left side"),
        [this] { sides_->setCurrentIndex(1); });
    add({QKeyCombination(Qt::ALT, Qt::Key_R)}, tr("show the right side"),
        [this] { sides_->setCurrentIndex(2); });
    keys.addGroup(tr("Decisions"));
    add({Qt::Key_A}, tr("accept the scene"), [this] { accept(); });
    add({Qt::Key_X}, tr("exclude the scene"), [this] { exclude(); });
    add(
        {Qt::Key_U}, tr("heights up by 5 mm"), [this] { heightUp(); }, true);
    add(
        {Qt::Key_D}, tr("heights down by 5 mm"), [this] { heightDown(); }, true);
    add(
        {Qt::Key_F}, tr("tilt: higher ahead"), [this] { tiltUp(); }, true);
    add(
        {Qt::Key_G}, tr("tilt: lower ahead"), [this] { tiltDown(); }, true);
    add(
        {Qt::Key_K}, tr("cloud ahead by 2 cm"), [this] { moveAhead(); }, true);
    add(
        {Qt::Key_J}, tr("cloud back by 2 cm"), [this] { moveBack(); }, true);
    add({Qt::Key_0}, tr("no nudge"), [this] { resetNudge(); });
    add({QKeyCombination(Qt::CTRL, Qt::Key_Z)}, tr("undo the last decision"), [this] { undo(); });
    add({QKeyCombination(Qt::CTRL, Qt::Key_E)}, tr("write the scenes with these decisions"),
        [this] { askForExport(); });
}

}  // namespace terratact
