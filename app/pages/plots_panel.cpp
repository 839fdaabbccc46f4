#include "app/pages/plots_panel.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/display/units.h"
#include "app/pages/plot_sets.h"
#include "app/plotting/signal_catalogue.h"
#include "app/shell/preferences/preference_store.h"
#include "widgets/base/elided_label.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/signals/plot_values.h"
#include "widgets/signals/signal_list.h"
#include "widgets/signals/time_plots.h"

namespace terratact {
namespace {

constexpr double kList = 0.5;   // [s] update period of the list of signals
constexpr double kZoom = 1.6;   // of a press on a button
constexpr double kMove = 0.25;  // of the span, of a press on a button

/// Frames are shown in the units that their descriptions name.
ShownUnit unitOf(const PlotSignal& signal)
{
    const bool isSi =
        signal.origin == SignalOrigin::Telemetry || signal.origin == SignalOrigin::Estimate;
    return isSi ? shownUnit(signal.unit) : ShownUnit{format::line(signal.unit)};
}

QString nameOf(const PlotSignal& signal)
{
    const QString name = translated(signal.name);
    return signal.frame.empty() ? name
                                : QStringLiteral("%1 %2").arg(format::line(signal.frame), name);
}

QString listText(const PlotSignal& signal)
{
    const QString unit = unitOf(signal).name;
    const QString name =
        unit.isEmpty() ? nameOf(signal) : QStringLiteral("%1 [%2]").arg(nameOf(signal), unit);
    return QStringLiteral("%1 · %2").arg(name, translated(describe(signal.origin)));
}

}  // namespace

PlotsPanel::PlotsPanel(PlotSource& source, PreferenceStore& preferences, Kind kind, QWidget* parent)
    : QWidget(parent), source_(source), preferences_(preferences), kind_(kind)
{
    plots_ = new TimePlots(this);
    values_ = new PlotValues(this);
    note_ = new ElidedLabel(this);
    note_->setAccessibleName(tr("State of the plots"));
    setTone(*note_, Tone::Muted);
    auto* tools = new QHBoxLayout;
    tools->setSpacing(6);
    auto* right = new QVBoxLayout;
    right->setSpacing(6);
    right->addLayout(tools);
    right->addWidget(plots_, 3);
    right->addWidget(values_, 1);
    auto* both = new QHBoxLayout(this);
    both->setContentsMargins(12, 10, 12, 10);
    both->setSpacing(10);
    both->addWidget(builtSide());
    both->addLayout(right, 1);
    buildTools(*tools);
    connectPlots();
    resizeToFont();

    PlotRows rows = SignalCatalogue::usualRows();
    for (const PlotSet& set : savedPlotSets(preferences_))
        if (set.name == kLastPlotSet) rows = set.rows;
    state_.setRows(std::move(rows));
    state_.setEnds(source_.begin(), source_.end());
    if (kind_ == Kind::Live)
        state_.follow();
    else
        state_.showAll();
    showSets();
    // A console keeps values before the page is seen; a session is read only once it is.
    if (kind_ == Kind::Live) chooseSignals();
    showSignals();
}

void PlotsPanel::chooseSignals()
{
    isChosen_ = true;
    source_.choose(state_.keys());
}

QPushButton* PlotsPanel::button(const QString& text, const QString& name, const QString& tip)
{
    auto* made = new QPushButton(text, this);
    made->setAccessibleName(name);
    made->setFocusPolicy(Qt::TabFocus);
    setTip(*made, tip);
    return made;
}

QWidget* PlotsPanel::builtSide()
{
    side_ = new QWidget(this);
    auto* column = new QVBoxLayout(side_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    sets_ = new QComboBox(side_);
    sets_->setEditable(true);
    sets_->setInsertPolicy(QComboBox::NoInsert);
    sets_->setAccessibleName(tr("Saved set of plots"));
    sets_->lineEdit()->setPlaceholderText(tr("name of a set"));
    sets_->lineEdit()->setMaxLength(60);
    sets_->lineEdit()->setAccessibleName(tr("Name of a set"));
    sets_->lineEdit()->setFocusPolicy(Qt::ClickFocus);  // Tab reaches the box around it
    save_ = button(tr("Save set"), tr("Save set"), tr("Saves these plots under the name above"));
    delete_ = button(tr("Delete set"), tr("Delete set"), tr("Deletes the saved set of this name"));
    auto* setKeys = new QHBoxLayout;
    setKeys->addWidget(save_);
    setKeys->addWidget(delete_);
    list_ = new SignalList(side_);
    newPlot_ = button(tr("New plot"), tr("New plot"), tr("Plots the chosen signal in a new row"));
    addTo_ = button(tr("Add to plot"), tr("Add to plot"),
                    tr("Adds the chosen signal to the chosen plot, which has a frame"));
    remove_ = button(tr("Remove plot"), tr("Remove plot"), tr("Removes the chosen plot"));
    auto* addKeys = new QHBoxLayout;
    addKeys->addWidget(newPlot_);
    addKeys->addWidget(addTo_);
    column->addWidget(sets_);
    column->addLayout(setKeys);
    column->addWidget(list_, 1);
    column->addLayout(addKeys);
    column->addWidget(remove_);
    connect(sets_, &QComboBox::textActivated, this, &PlotsPanel::useSet);
    connect(save_, &QPushButton::clicked, this, &PlotsPanel::saveSet);
    connect(delete_, &QPushButton::clicked, this, &PlotsPanel::deleteSet);
    connect(newPlot_, &QPushButton::clicked, this,
            [this] { addSignal(list_->chosenKey(), plots_->rows()); });
    connect(addTo_, &QPushButton::clicked, this,
            [this] { addSignal(list_->chosenKey(), std::max(0, state_.chosen())); });
    connect(remove_, &QPushButton::clicked, this, &PlotsPanel::removeChosen);
    connect(list_, &SignalList::wanted, this,
            [this](const QString& key) { addSignal(key, plots_->rows()); });
    connect(list_, &SignalList::dragged, this,
            [this](const QString&, const QPoint& at) { plots_->setTarget(plots_->rowAt(at)); });
    connect(list_, &SignalList::dropped, this, [this](const QString& key, const QPoint& at) {
        if (const int row = plots_->rowAt(at); row >= 0) addSignal(key, row);
    });
    connect(list_, &SignalList::dragEnded, this, [this] { plots_->setTarget(-1); });
    return side_;
}

void PlotsPanel::buildTools(QHBoxLayout& row)
{
    const auto act = [this, &row](const QString& text, const QString& name, const QString& tip,
                                  const std::function<void()>& does) {
        QPushButton* const made = button(text, name, tip);
        row.addWidget(made);
        connect(made, &QPushButton::clicked, this, [this, does] {
            does();
            showNow();
        });
        return made;
    };
    act(QStringLiteral("+"), tr("Closer"),
        tr("Shows a shorter time; also the wheel, or a box drawn with the mouse"),
        [this] { state_.zoom(kZoom, cursor()); });
    act(QStringLiteral("\u2212"), tr("Wider"), tr("Shows a longer time"),
        [this] { state_.zoom(1.0 / kZoom, cursor()); });
    act(QStringLiteral("◀"), tr("Earlier"),
        tr("Moves to earlier times; also a drag with the right button, or the wheel with Shift"),
        [this] { state_.move(-kMove * (state_.to() - state_.from())); });
    act(QStringLiteral("▶"), tr("Later"), tr("Moves to later times"),
        [this] { state_.move(kMove * (state_.to() - state_.from())); });
    act(QStringLiteral("◂|"), tr("Cursor earlier"),
        tr("Moves the cursor by a hundredth of the time in sight"), [this] {
            const double to = cursor() - 0.01 * (state_.to() - state_.from());
            state_.setCursor(to);
            if (kind_ == Kind::Review) emit seekWanted(to);
        });
    act(QStringLiteral("|▸"), tr("Cursor later"),
        tr("Moves the cursor by a hundredth of the time in sight"), [this] {
            const double to = cursor() + 0.01 * (state_.to() - state_.from());
            state_.setCursor(to);
            if (kind_ == Kind::Review) emit seekWanted(to);
        });
    act(tr("All"), tr("All"), tr("Shows everything"), [this] { state_.showAll(); });
    live_ = act(tr("Live"), tr("Live"), tr("Follows the newest values"), [this] {
        state_.setCursor(std::nullopt);
        state_.follow();
    });
    live_->setVisible(kind_ == Kind::Live);
    act(tr("Fit"), tr("Fit"), tr("Fits the scales to the values in sight"),
        [this] { state_.fitValues(); });
    row.addWidget(note_, 1);
    numbers_ = button(tr("Numbers"), tr("Numbers"),
                      tr("Shows the values at the cursor and the statistics of the time in sight"));
    connect(numbers_, &QPushButton::toggled, values_, &QWidget::setVisible);
    row.addWidget(numbers_);
    dock_ = button(tr("Dock"), tr("Dock"),
                   tr("Keeps the plots below every page, where the window is high enough"));
    connect(dock_, &QPushButton::toggled, this, &PlotsPanel::dockWanted);
    row.addWidget(dock_);
    for (QPushButton* const toggle : {live_, numbers_, dock_}) {
        toggle->setCheckable(true);
        toggle->setProperty("role", "toggle");
    }
    numbers_->setChecked(true);
}

void PlotsPanel::connectPlots()
{
    connect(plots_, &TimePlots::pointed, this, [this](double seconds) {
        pointer_ = seconds;
        showNow();
    });
    connect(plots_, &TimePlots::pointerLeft, this, [this] {
        pointer_.reset();
        showNow();
    });
    connect(plots_, &TimePlots::clicked, this, [this](double seconds) {
        state_.setCursor(seconds);
        if (kind_ == Kind::Review) emit seekWanted(seconds);
        showNow();
    });
    connect(plots_, &TimePlots::boxed, this, [this](int row, const PlotBox& box) {
        state_.show(box.from, box.to);
        state_.setValues(static_cast<std::size_t>(row), {box.low, box.high});
        showNow();
    });
    connect(plots_, &TimePlots::zoomed, this, [this](double factor, double at) {
        state_.zoom(factor, at);
        showNow();
    });
    connect(plots_, &TimePlots::moved, this, [this](double seconds) {
        state_.move(seconds);
        showNow();
    });
    connect(plots_, &TimePlots::rowChosen, this, [this](int row) {
        state_.choose(row);
        showNow();
    });
}

void PlotsPanel::addSignal(const QString& key, int row)
{
    if (key.isEmpty()) return;
    full_ = state_.add(key.toStdString(), static_cast<std::size_t>(std::max(0, row)))
              ? QString()
              : tr("No room: at most %1 plots, %2 signals in each, %3 in all")
                    .arg(PlotsState::kMaxRows)
                    .arg(PlotsState::kMaxInRow)
                    .arg(PlotSource::kMaxChosen);
    chosenChanged();
}

void PlotsPanel::removeChosen()
{
    if (state_.chosen() < 0) return;
    state_.removeRow(static_cast<std::size_t>(state_.chosen()));
    full_.clear();
    chosenChanged();
}

void PlotsPanel::chosenChanged()
{
    chooseSignals();
    savePlotSet(preferences_, {kLastPlotSet, state_.rows()});
    showSignals();
    showNow();
}

void PlotsPanel::showSignals()
{
    QList<ListedSignal> listed;
    const auto keys = state_.keys();
    known_.clear();
    for (PlotSignal& signal : source_.catalogue()) {
        const std::string key = signal.key();
        listed << ListedSignal{QString::fromStdString(key), listText(signal),
                               std::find(keys.begin(), keys.end(), key) != keys.end()};
        known_[key] = std::move(signal);
    }
    list_->setSignals(listed);
}

double PlotsPanel::cursor() const
{
    if (pointer_) return *pointer_;
    if (state_.cursor()) return *state_.cursor();
    return kind_ == Kind::Live ? state_.end() : 0.5 * (state_.from() + state_.to());
}

void PlotsPanel::showRows()
{
    TimePlotsViewState shown{.rows = {},
                             .from = state_.from(),
                             .to = state_.to(),
                             .zero = state_.begin(),
                             .until = state_.end(),
                             .cursor = pointer_ ? pointer_ : state_.cursor(),
                             .chosen = state_.chosen()};
    std::vector<PlottedValues> values;
    const PlotSpan span{.from = state_.from(),
                        .to = state_.to(),
                        .columns = static_cast<std::size_t>(plots_->columns()),
                        .cursor = cursor()};
    for (std::size_t i = 0; i < state_.rows().size(); ++i) {
        TimePlotRow& row = shown.rows.emplace_back();
        row.values = state_.values(i);
        for (const std::string& key : state_.rows()[i]) {
            const auto found = known_.find(key);
            const PlotSignal* const signal = found != known_.end() ? &found->second : nullptr;
            // A frame that did not come yet is known by its key.
            const ShownUnit unit = signal ? unitOf(*signal) : ShownUnit{};
            TimePlotCurve curve{.name = signal ? nameOf(*signal)
                                               : format::line(key.substr(key.find(':') + 1)),
                                .unit = unit.name,
                                .view = times(source_.view(key, span), unit.factor),
                                .isHeld = signal && signal->isHeld()};
            values.push_back({.row = static_cast<int>(i) + 1,
                              .name = curve.name,
                              .unit = curve.unit,
                              .atCursor = curve.view.atCursor,
                              .visible = curve.view.visible});
            row.curves.push_back(std::move(curve));
        }
    }
    plots_->setViewState(std::move(shown));
    values_->setValues(std::move(values));
}

void PlotsPanel::showNote()
{
    QString text = full_;
    const bool isRead = source_.share() >= 1.0;
    if (const Message trouble = source_.trouble(); !trouble.empty())
        text = translated(trouble);
    else if (!isRead)
        text = tr("the session is read: %1 %").arg(format::percent(source_.share()));
    if (note_->text() != text) note_->setText(text);
    live_->setChecked(state_.follows());
    addTo_->setEnabled(state_.chosen() >= 0);
    remove_->setEnabled(state_.chosen() >= 0);
}

void PlotsPanel::showNow()
{
    if (!isChosen_) chooseSignals();
    shownVersion_ = source_.version();  // before its values: more may come
    state_.setEnds(source_.begin(), source_.end());
    showRows();
    showNote();
}

void PlotsPanel::refresh(double now, bool force)
{
    if (!force && now - refreshedAt_ < kRefresh - 1e-3) return;
    refreshedAt_ = now;
    if (now - listedAt_ >= kList && side_->isVisible()) {
        listedAt_ = now;
        showSignals();
    }
    const bool moves = kind_ == Kind::Live && state_.follows();
    if (force || moves || source_.version() != shownVersion_) showNow();
}

void PlotsPanel::setTime(double seconds)
{
    state_.setCursor(seconds);
    state_.keepInView(seconds);
    if (isVisible()) showNow();
}

void PlotsPanel::setDocked(bool docked)
{
    side_->setVisible(!docked);
    numbers_->setVisible(!docked);
    values_->setVisible(!docked && numbers_->isChecked());
    layout()->setContentsMargins(docked ? QMargins(12, 2, 12, 4) : QMargins(12, 10, 12, 10));
}

void PlotsPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (changesFont(*event) && remove_) resizeToFont();
}

void PlotsPanel::resizeToFont()
{
    for (QPushButton* made : findChildren<QPushButton*>()) {
        made->setMinimumHeight(scaled(kTarget));
        if (made->text().size() <= 2) made->setFixedWidth(scaled(40));
    }
    sets_->setMinimumHeight(scaled(kTarget + 4));  // its field keeps the size of a target
    side_->setFixedWidth(scaled(236));
}

}  // namespace terratact
