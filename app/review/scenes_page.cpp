#include "app/review/scenes_page.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "core/base/degree.h"
#include "widgets/base/card.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/plain_table.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

QString millimetres(double metres)
{
    return SceneRows::tr("%1 mm").arg(format::number(1000.0 * metres, 0));
}

/// Returns the median of the scenes' median errors [m]; empty: none is known.
std::optional<double> medianOf(std::vector<double> errors)
{
    if (errors.empty()) return std::nullopt;
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    return *middle;
}

}  // namespace

SceneRows::SceneRows(const std::vector<TwoTrackScene>& scenes, QObject* parent)
    : QAbstractTableModel(parent), scenes_(scenes), results_(scenes.size())
{
}

void SceneRows::setResult(std::size_t scene, SceneResult result)
{
    if (!results_[scene]) ++known_;
    results_[scene] = std::move(result);
    const int row = static_cast<int>(scene);
    emit dataChanged(index(row, Median), index(row, Answer));
}

void SceneRows::forget()
{
    results_.assign(scenes_.size(), std::nullopt);
    known_ = 0;
    emit dataChanged(index(0, Median), index(rowCount() - 1, Answer));
}

std::optional<std::size_t> SceneRows::nextWithout(std::size_t from) const
{
    for (std::size_t k = 0; k < results_.size(); ++k)
        if (const std::size_t scene = (from + k) % results_.size(); !results_[scene]) return scene;
    return std::nullopt;
}

int SceneRows::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(scenes_.size());
}

int SceneRows::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kColumns;
}

QVariant SceneRows::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case Number: return tr("scene");
    case Drive: return tr("drive");
    case Time: return tr("time [s]");
    case Pitch: return tr("pitch");
    case Roll: return tr("roll");
    case Truth: return tr("truth");
    case Median: return tr("error, median");
    case Mean: return tr("error, mean");
    case Answer: return tr("verdict");
    default: return {};
    }
}

QVariant SceneRows::data(const QModelIndex& index, int role) const
{
    const auto scene = static_cast<std::size_t>(index.row());
    const int column = index.column();
    const bool isText = column == Drive || column == Answer || column == Truth;
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue((isText ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole) return plainTip(text(scene, column));
    return role == Qt::DisplayRole ? QVariant(text(scene, column)) : QVariant();
}

QString SceneRows::text(std::size_t scene, int column) const
{
    const TwoTrackScene& row = scenes_[scene];
    const std::optional<SceneResult>& result = results_[scene];
    const SceneError* const error = result && result->error ? &*result->error : nullptr;
    switch (column) {
    case Number: return QString::number(scene + 1);
    case Drive: return format::shownName(row.run);
    case Time: return format::number(row.time, 2);
    case Pitch: return format::angle(row.s.pitch);
    case Roll: return format::angle(row.s.roll);
    case Truth: {
        const int known = knownHeights(row.truth);
        return known > 0 ? tr("%1 bins").arg(known) : tr("unknown");
    }
    case Median: return error ? millimetres(error->median) : QString();
    case Mean: return error ? millimetres(error->mean) : QString();
    case Answer:
        if (!result) return QString(QChar(0x2026));
        return result->trouble.empty() ? translated(describe(result->verdict))
                                       : translatedLine(result->trouble);
    default: return {};
    }
}

ScenesPage::ScenesPage(SceneRows& rows, QWidget* parent) : Page(parent), rows_(rows)
{
    auto* card = new Card(tr("Scenes of the file"), this);
    summary_ = new PlainLabel(card);
    summary_->setWordWrap(true);
    summary_->setAccessibleName(tr("Summary of the scenes"));
    table_ = new QTableView(card);
    table_->setModel(&rows);
    table_->setAccessibleName(tr("Scenes of the file"));
    setTip(*table_, tr("Enter or a double click shows the scene; typing a number goes to it"));
    chooseRows(*table_);
    card->body()->addWidget(summary_);
    card->body()->addWidget(table_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    column->addWidget(card);
    connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
        emit wanted(static_cast<std::size_t>(index.row()));
    });
    resizeToFont();
    showSummary();
}

void ScenesPage::showSummary()
{
    std::vector<double> errors;
    int clear = 0, blocked = 0, cannotTell = 0;
    for (int row = 0; row < rows_.rowCount(); ++row) {
        const auto& result = rows_.result(static_cast<std::size_t>(row));
        if (!result || !result->trouble.empty()) continue;
        if (result->error) errors.push_back(result->error->median);
        ++(result->verdict == StepVerdict::Clear     ? clear
           : result->verdict == StepVerdict::Blocked ? blocked
                                                     : cannotTell);
    }
    const auto middle = medianOf(std::move(errors));
    const QString verdicts =
        tr("%1 CLEAR, %2 BLOCKED, %3 CANNOT TELL").arg(clear).arg(blocked).arg(cannotTell);
    summary_->setText(
        tr("%1 of %2 scenes estimated now · %3 · %4")
            .arg(rows_.known())
            .arg(rows_.rowCount())
            .arg(verdicts,
                 middle ? tr("median error of the median scene: %1").arg(millimetres(*middle))
                        : tr("no truth is known")));
}

void ScenesPage::choose(std::size_t scene)
{
    const int row = static_cast<int>(scene);
    if (table_->currentIndex().row() != row) table_->selectRow(row);
}

void ScenesPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    table_->setFocus();
}

void ScenesPage::changeEvent(QEvent* event)
{
    Page::changeEvent(event);
    if (changesFont(*event) && table_) resizeToFont();
}

void ScenesPage::resizeToFont()
{
    fitRows(*table_, fontMetrics());
    const auto fit = [this](int column, const QString& text) {
        table_->setColumnWidth(column, columnWidthFor(*table_, fontMetrics(), column, {text}));
    };
    fit(SceneRows::Number, QStringLiteral("100000"));
    fit(SceneRows::Drive, QStringLiteral("a drive 1000"));
    fit(SceneRows::Time, QStringLiteral("10000.00"));
    fit(SceneRows::Pitch, format::angle(10.0 * kDegree));
    fit(SceneRows::Roll, format::angle(10.0 * kDegree));
    fit(SceneRows::Truth, SceneRows::tr("%1 bins").arg(22));
    fit(SceneRows::Median, QStringLiteral("1000 mm"));
    fit(SceneRows::Mean, QStringLiteral("1000 mm"));
}

}  // namespace terratact
