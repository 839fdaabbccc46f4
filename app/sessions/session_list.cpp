#include "app/sessions/session_list.h"

#include <QDateTime>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "core/infer/verdict/verdict.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr std::int64_t kNanosecondsInMillisecond = 1'000'000;
constexpr qsizetype kMaxSearch = 20'000;  // characters of a row that are searched

QString robotText(const ListedSession& session)
{
    if (!session.summary) return {};
    const QString robot = format::shownName(session.summary->robot);
    return robot.isEmpty() ? format::sourceName(session.summary->source) : robot;
}

QDateTime localTime(std::int64_t wallTime)
{
    return QDateTime::fromMSecsSinceEpoch(wallTime / kNanosecondsInMillisecond);
}

/// Returns the begin to the minute, as short as a column wants it.
QString beginMinute(const ListedSession& session)
{
    const QString minute =
        localTime(session.wallTime()).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    return session.summary ? minute : QStringLiteral("≤ ") + minute;
}

/// Returns all notes, those of the recording first.
QStringList notesOf(const ListedSession& session)
{
    QStringList notes;
    if (session.summary)
        for (const std::string& note : session.summary->notes) notes << format::line(note);
    for (const std::string& note : session.reviewNotes) notes << format::line(note);
    return notes;
}

QString searchText(const ListedSession& session)
{
    QStringList all{beginText(session),
                    robotText(session),
                    verdictsText(session),
                    stateText(session),
                    sizeText(session.bytes),
                    format::line(session.path.substr(session.path.find_last_of('/') + 1)),
                    translatedLine(session.trouble)};
    if (session.summary)
        all << format::sourceName(session.summary->source)
            << format::line(session.summary->program);
    all += notesOf(session);
    return all.join(QLatin1Char('\n')).left(kMaxSearch);
}

QString count(std::int64_t number)
{
    return number == 0 ? QString() : QString::number(number);
}

}  // namespace

QString verdictsText(const ListedSession& session)
{
    if (!session.summary) return {};
    const SessionVerdicts& found = session.summary->verdicts;
    QStringList parts;
    const auto add = [&parts](std::int64_t number, StepVerdict verdict) {
        if (number > 0)
            parts << QStringLiteral("%1 %2").arg(number).arg(translated(describe(verdict)));
    };
    add(found.clear, StepVerdict::Clear);
    add(found.blocked, StepVerdict::Blocked);
    add(found.cannotTell, StepVerdict::CannotTell);
    if (found.notRead > 0) parts << SessionList::tr("%1 not read").arg(found.notRead);
    return parts.join(QStringLiteral(" · "));
}

QString stateText(const ListedSession& session)
{
    if (session.isRecorded) return SessionList::tr("● being recorded");
    if (!session.summary) return SessionList::tr("✕ cannot be read");
    switch (session.summary->closing) {
    case SessionClosing::Open: return SessionList::tr("○ not closed");
    case SessionClosing::Torn: return SessionList::tr("✕ torn");
    case SessionClosing::Sealed: break;
    }
    return session.summary->damage ? SessionList::tr("✕ damaged") : SessionList::tr("✓ sealed");
}

QString notesText(const ListedSession& session)
{
    const std::int64_t number = session.notes();
    if (number == 0) return {};
    const QStringList notes = notesOf(session);
    return notes.isEmpty()
             ? QString::number(number)
             : QStringLiteral("%1: %2").arg(number).arg(notes.join(QLatin1String("; ")));
}

QString sizeText(std::int64_t bytes)
{
    if (bytes < 100'000)
        return SessionList::tr("%1 kB").arg(format::number(1e-3 * static_cast<double>(bytes), 1));
    const double megabytes = 1e-6 * static_cast<double>(bytes);
    return megabytes < 1000.0 ? SessionList::tr("%1 MB").arg(format::number(megabytes, 1))
                              : SessionList::tr("%1 GB").arg(format::number(1e-3 * megabytes, 2));
}

QString durationText(double seconds)
{
    const auto whole = static_cast<qint64>(std::llround(std::clamp(seconds, 0.0, 1e9)));
    const QString rest = QStringLiteral("%1:%2")
                             .arg(whole / 60 % 60, whole < 3600 ? 1 : 2, 10, QLatin1Char('0'))
                             .arg(whole % 60, 2, 10, QLatin1Char('0'));
    return whole < 3600 ? rest : QStringLiteral("%1:%2").arg(whole / 3600).arg(rest);
}

QString beginText(const ListedSession& session)
{
    const QString date =
        localTime(session.wallTime()).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
    return session.summary ? date : SessionList::tr("before %1").arg(date);
}

void SessionList::clear()
{
    beginResetModel();
    rows_.clear();
    endResetModel();
}

void SessionList::add(std::vector<ListedSession> sessions)
{
    if (sessions.empty()) return;
    const int before = rowCount();
    beginInsertRows({}, before, before + static_cast<int>(sessions.size()) - 1);
    rows_.reserve(rows_.size() + sessions.size());
    for (ListedSession& session : sessions) {
        QString search = searchText(session);
        rows_.push_back({std::move(session), std::move(search)});
    }
    endInsertRows();
}

int SessionList::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int SessionList::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kColumns;
}

QVariant SessionList::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) return {};
    const bool isNumber =
        section == Lasts || section == Probes || section == Alarms || section == Size;
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    switch (section) {
    case Ground: return tr("ground");
    case Begins: return tr("begins");
    case Robot: return tr("robot");
    case Lasts: return tr("lasts");
    case Verdicts: return tr("verdicts");
    case Probes: return tr("probes");
    case Alarms: return tr("alarms");
    case Size: return tr("size");
    case State: return tr("state");
    case Notes: return tr("notes");
    default: return {};
    }
}

QVariant SessionList::data(const QModelIndex& index, int role) const
{
    const ListedSession& session = at(index.row());
    const int column = index.column();
    if (role == kSortRole) return sortValue(session, column);
    if (role == kSearchRole) return rows_[static_cast<std::size_t>(index.row())].search;
    if (role == Qt::TextAlignmentRole) return headerData(column, Qt::Horizontal, role);
    if (role == Qt::ToolTipRole) {  // the column may be too narrow for the text
        const QString text =
            data(index, column == Begins ? Qt::AccessibleTextRole : Qt::DisplayRole).toString();
        return text.isEmpty() ? QVariant() : plainTip(text);
    }
    if (role != Qt::DisplayRole && role != Qt::AccessibleTextRole) return {};
    const SessionSummary* const summary = session.summary ? &*session.summary : nullptr;
    switch (column) {
    case Ground:
        if (role != Qt::AccessibleTextRole) return {};
        return summary && summary->last ? tr("picture of the last estimate") : tr("no estimate");
    case Begins: return role == Qt::DisplayRole ? beginMinute(session) : beginText(session);
    case Robot:
        return session.trouble.empty() ? robotText(session) : translatedLine(session.trouble);
    case Lasts: return summary ? durationText(session.seconds()) : QString();
    case Verdicts: return verdictsText(session);
    case Probes: return summary ? count(summary->probes) : QString();
    case Alarms: return summary ? count(summary->alarms) : QString();
    case Size: return sizeText(session.bytes);
    case State: return stateText(session);
    case Notes: return notesText(session);
    default: return {};
    }
}

/// Returns numbers for columns of numbers. Verdicts are sorted by BLOCKED, then CANNOT TELL, then CLEAR.
QVariant SessionList::sortValue(const ListedSession& session, int column) const
{
    const auto number = [](std::int64_t value) { return QVariant(static_cast<qlonglong>(value)); };
    if (column == Begins) return number(session.wallTime());
    if (column == Size) return number(session.bytes);
    if (column == Lasts) return session.seconds();
    if (column == Notes) return number(session.notes());
    if (column == Robot) return robotText(session);
    if (column == State) return stateText(session);
    if (!session.summary) return column == Verdicts ? QVariant(-1.0) : number(-1);
    switch (column) {
    case Ground: return number(session.summary->last ? 1 : 0);
    case Verdicts: {
        const SessionVerdicts& found = session.summary->verdicts;
        return static_cast<double>(found.blocked) * 1e12
             + static_cast<double>(found.cannotTell) * 1e6 + static_cast<double>(found.clear);
    }
    case Probes: return number(session.summary->probes);
    default: return number(session.summary->alarms);
    }
}

SearchedSessions::SearchedSessions(SessionList& list, QObject* parent)
    : QSortFilterProxyModel(parent), list_(list)
{
    setSourceModel(&list);
    setSortRole(SessionList::kSortRole);
    setSortLocaleAware(true);
}

void SearchedSessions::search(const QString& words)
{
    words_ = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
}

const ListedSession& SearchedSessions::at(int row) const
{
    return list_.at(mapToSource(index(row, 0)).row());
}

bool SearchedSessions::filterAcceptsRow(int row, const QModelIndex& parent) const
{
    const QString text =
        list_.data(list_.index(row, 0, parent), SessionList::kSearchRole).toString();
    return std::ranges::all_of(
        words_, [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace terratact
