#include "app/imports/truth_rows.h"

#include <QStringList>
#include <algorithm>

#include "app/display/format.h"
#include "widgets/base/tips.h"

namespace terratact {

QString gapText(TruthGap gap)
{
    switch (gap) {
    case TruthGap::None: return {};
    case TruthGap::OtherRun: return TruthRows::tr("another run");
    case TruthGap::NoPose: return TruthRows::tr("no pose around its time");
    case TruthGap::OffCloud: return TruthRows::tr("left out: the robot lies off the cloud");
    case TruthGap::NoCloud: return TruthRows::tr("no bin is known well enough");
    case TruthGap::Excluded: return TruthRows::tr("excluded");
    }
    return {};
}

QString nudgeText(const TruthDecision* decision)
{
    if (!decision) return {};
    QStringList parts;
    if (decision->offset != 0.0)
        parts << TruthRows::tr("%1 mm").arg(format::signedNumber(1000.0 * decision->offset, 0));
    if (decision->tilt != 0.0) parts << format::angle(decision->tilt, 1);
    if (decision->along != 0.0)
        parts
            << TruthRows::tr("%1 mm along").arg(format::signedNumber(1000.0 * decision->along, 0));
    return parts.join(QStringLiteral(", "));
}

QString decisionText(const TruthDecision* decision)
{
    if (!decision) return TruthRows::tr("open");
    return decision->kind == TruthDecision::Kind::Accept ? TruthRows::tr("accepted")
                                                         : TruthRows::tr("excluded");
}

TruthRows::TruthRows(const LaserTruth& truth, const TruthChoices& choices, QObject* parent)
    : QAbstractTableModel(parent), truth_(truth), choices_(choices)
{
}

void TruthRows::refresh(std::size_t row)
{
    const int at = static_cast<int>(row);
    emit dataChanged(index(at, 0), index(at, kColumns - 1));
}

void TruthRows::refreshAll()
{
    emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int TruthRows::known(const SceneTruth& scene, bool isPlane)
{
    const auto count = [](const SideTruth& bins) {
        return static_cast<int>(std::ranges::count_if(
            bins, [](const BinTruth& bin) { return bin.height.has_value(); }));
    };
    return isPlane ? count(scene.plane) : count(scene.side[0]) + count(scene.side[1]);
}

int TruthRows::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(truth_.scenes());
}

int TruthRows::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kColumns;
}

QVariant TruthRows::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case Number: return tr("scene");
    case Decision: return tr("decision");
    case Drive: return tr("drive");
    case Time: return tr("time [s]");
    case Cloud: return tr("cloud");
    case Known: return tr("bins");
    case Nudge: return tr("nudge");
    default: return {};
    }
}

QVariant TruthRows::data(const QModelIndex& index, int role) const
{
    const auto row = static_cast<std::size_t>(index.row());
    const int column = index.column();
    const bool isText = column == Decision || column == Drive || column == Nudge;
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue((isText ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole) return plainTip(text(row, column));
    return role == Qt::DisplayRole ? QVariant(text(row, column)) : QVariant();
}

QString TruthRows::text(std::size_t row, int column) const
{
    const SceneTruth& scene = truth_.truths[row];
    const TruthDecision* const decision = choices_.decision(row);
    switch (column) {
    case Number: return QString::number(row + 1);
    case Decision:
        return decision || scene.gap == TruthGap::None ? decisionText(decision)
                                                       : gapText(scene.gap);
    case Drive: return format::shownName(truth_.runOf(row));
    case Time: return format::number(truth_.timeOf(row), 1);
    case Cloud:
        return scene.contact
                 ? tr("%1 mm").arg(format::signedNumber(-1000.0 * scene.contact->offset, 0))
                 : format::kNothing;
    case Known: return QString::number(known(scene, truth_.isPlane));
    case Nudge: return nudgeText(decision);
    default: return {};
    }
}

}  // namespace terratact
