#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <vector>

#include "app/display/format.h"

namespace terratact {
namespace {

// What the core says, for the translators: it is free of Qt and speaks English.  %1, %2, … stand for the numbers.
[[maybe_unused]] constexpr const char* kSentences[] = {
    QT_TRANSLATE_NOOP("core", "fast"),
    QT_TRANSLATE_NOOP("core", "balanced"),
    QT_TRANSLATE_NOOP("core", "accurate"),
    QT_TRANSLATE_NOOP("core", "roll %1°: the ground is not the same left and right"),
    QT_TRANSLATE_NOOP(
        "core", "left and right flippers differ by %1°: the ground is not the same left and right"),
    QT_TRANSLATE_NOOP("core", "contact and arm disagree about bin %1 m by %2 mm"),
    QT_TRANSLATE_NOOP("core", "no force was measured: the bands are wider"),
    QT_TRANSLATE_NOOP("core", "the force of element %1 was not measured: the bands are wider"),
    QT_TRANSLATE_NOOP("core", "no flipper current was measured: the bands are wider"),
    QT_TRANSLATE_NOOP("core", "the front flippers' current was not measured: the bands are wider"),
    QT_TRANSLATE_NOOP("core", "the rear flippers' current was not measured: the bands are wider"),
    QT_TRANSLATE_NOOP("core", "method clearance needs every current and force: local estimates"),
    QT_TRANSLATE_NOOP("core", "the processes use pitch and flipper angles alone"),
    QT_TRANSLATE_NOOP("core", "the arm found bin %1 m %2 mm above the robot's own lower edge"),
    QT_TRANSLATE_NOOP("core", "contact at x %1 m lies %2 mm above the robot's own lower edge"),
    QT_TRANSLATE_NOOP("core",
                      "unlike the training scenes: %1 times the distance that %2 % of them exceed"),
    QT_TRANSLATE_NOOP(
        "core",
        "a step ahead of more than %1 mm: probability %2 ± %3, likeliest between %4 and %5 m (%6)"),
    // clang-format off
    QT_TRANSLATE_NOOP("core", "a step ahead of more than %1 mm: probability %2 ± < %3, likeliest between %4 and %5 m (%6)"),
    // clang-format on
    QT_TRANSLATE_NOOP("core", "two heights are likely at %1 m: %2 m (%3 %) or %4 m (%5 %)"),
    QT_TRANSLATE_NOOP("core", "force %1"),
    QT_TRANSLATE_NOOP("core", "not changed for %1 s while the robot drove %2 m, stuck?"),
    QT_TRANSLATE_NOOP("core", "not changed for %1 s, not even by noise, stuck?"),
    QT_TRANSLATE_NOOP("core", "jumps away and comes back, loose contact?"),
    QT_TRANSLATE_NOOP("core", "reads what the robot cannot do"),
    QT_TRANSLATE_NOOP("core", "changes the wrong way, sign flipped?"),
    QT_TRANSLATE_NOOP("core", "moves with the other axle, front and rear swapped?"),
    QT_TRANSLATE_NOOP("core", "still changes when the robot stands still, late?"),
    QT_TRANSLATE_NOOP("core", "no load while the flippers press, disconnected?"),
    QT_TRANSLATE_NOOP("core", "loaded while nothing presses, drifted?"),
    QT_TRANSLATE_NOOP("core", "left and right differ by the same at every press"),
    QT_TRANSLATE_NOOP("core", "does not fit the ground driven over, offset or sign flipped?"),
    QT_TRANSLATE_NOOP("core", "load where no ground was, order reversed?"),
    QT_TRANSLATE_NOOP("core",
                      "does not fit the same ground driven in both directions, zero shifted?"),
    // clang-format off
    QT_TRANSLATE_NOOP("core", "the estimate contradicts the readings: pitch %1° measured, %2° on its ground; front flippers %3° measured, %4° on its ground"),
    // clang-format on
    QT_TRANSLATE_NOOP("core", "STOP is latched: release it first"),
    QT_TRANSLATE_NOOP("core", "The link must be good for a second"),
    QT_TRANSLATE_NOOP("core", "commands can leave"),
    QT_TRANSLATE_NOOP("core", "no other console sends commands"),
    QT_TRANSLATE_NOOP("core", "STOP is not latched"),
    QT_TRANSLATE_NOOP("core", "the link is good"),
    QT_TRANSLATE_NOOP("core", "nobody else has armed the robot"),
    QT_TRANSLATE_NOOP("core", "CLEAR"),
    QT_TRANSLATE_NOOP("core", "BLOCKED"),
    QT_TRANSLATE_NOOP("core", "CANNOT TELL"),
    QT_TRANSLATE_NOOP("core", "yes"),
    QT_TRANSLATE_NOOP("core", "no"),
    QT_TRANSLATE_NOOP("core", "none"),
    QT_TRANSLATE_NOOP("core", "not measured"),
    QT_TRANSLATE_NOOP("core",
                      "chains not converged: R-hat %1 (limit %2), effective draws %3 (limit %4)"),
    // NOLINTNEXTLINE(bugprone-suspicious-missing-comma)
    QT_TRANSLATE_NOOP("core", "chains not converged when time was out: R-hat %1 (limit %2), "
                              "effective draws %3 (limit %4)"),
    QT_TRANSLATE_NOOP("core",
                      "the model of bin %1 m is singular: %2 of its variance was added as noise"),
    // What is wrong with a file, a bus or the panel: after its name, and before what the system says.
    QT_TRANSLATE_NOOP("core", "cannot be written"),
    QT_TRANSLATE_NOOP("core", "the disk is full"),
    QT_TRANSLATE_NOOP("core",
                      "only %1 MB are free, %2 MB are left alone; recording goes on when there is "
                      "room"),
    QT_TRANSLATE_NOOP("core", "not sent"),
    QT_TRANSLATE_NOOP("core", "not sent, the kernel's queue is full"),
    QT_TRANSLATE_NOOP("core", "not readable"),
    QT_TRANSLATE_NOOP("core", "the panel is absent"),
    QT_TRANSLATE_NOOP("core", "the lines were refused"),
    QT_TRANSLATE_NOOP("core", "another program, or the kernel,"),
    QT_TRANSLATE_NOOP(
        "core", "a line is in use by another program, or by the kernel; gpioinfo shows which"),
    QT_TRANSLATE_NOOP("core", "the chip is gone: unplugged, or its driver was removed"),
    QT_TRANSLATE_NOOP("core", "reading an edge"),
    QT_TRANSLATE_NOOP("core", "reading a level"),
    QT_TRANSLATE_NOOP("core", "reading the levels"),
    QT_TRANSLATE_NOOP("core", "waiting for an edge"),
    QT_TRANSLATE_NOOP("core", "setting an output"),
    QT_TRANSLATE_NOOP("core", "is not TOML"),
    QT_TRANSLATE_NOOP("core", "a stop line needs a name of %1 to %2 characters"),
    // What mends a kernel without CAN.
    QT_TRANSLATE_NOOP("core",
                      "sudo modprobe can_raw   (where that fails: a kernel with CONFIG_CAN_RAW)"),
    QT_TRANSLATE_NOOP("core", "run it outside of the sandbox or container that forbids it, or as "
                              "another user"),
    // What a session tells, and what is told of sessions.
    QT_TRANSLATE_NOOP("core", "session recovered, whose program had ended without closing it"),
    QT_TRANSLATE_NOOP("core", "session not recovered"),
    QT_TRANSLATE_NOOP("core", "session deleted, since it is older than you have set"),
    QT_TRANSLATE_NOOP("core", "session deleted, since all together are larger than you have set"),
    QT_TRANSLATE_NOOP("core",
                      "%1 sessions of %2 MB are beyond the limits that you have set; none is "
                      "deleted until the page of the settings says that they may be"),
    QT_TRANSLATE_NOOP("core", "there is no home folder to record in: --sessions names another"),
    QT_TRANSLATE_NOOP("core", "gaps before: %1, the longest %2 s"),
    // Events of a session.
    QT_TRANSLATE_NOOP("core", "closed with the console"),
    QT_TRANSLATE_NOOP("core", "the program that recorded ended without closing the session"),
    QT_TRANSLATE_NOOP("core", "from a log of CAN frames"),
    QT_TRANSLATE_NOOP("core", "frames that were lost when the log was recorded"),
    QT_TRANSLATE_NOOP("core", "%1 frames and %2 other rows are not here: there was no room while "
                              "the disk was slow or full, or they could not be written"),
    QT_TRANSLATE_NOOP(
        "core", "at line %1 the log's clock was set back by %2 s; the session goes on evenly"),
    QT_TRANSLATE_NOOP(
        "core", "at line %1 the log's clock was set forward by %2 s; the session goes on evenly"),
    QT_TRANSLATE_NOOP("core", "the log's clock was set back %1 more times"),
    QT_TRANSLATE_NOOP("core", "the end of the log is torn"),
    QT_TRANSLATE_NOOP("core", "has no scenes"),
    QT_TRANSLATE_NOOP("core", "the model gives no finite estimate of this scene"),
};

// Of events as sessions have them, apart from the sentences: files, sources and signals may have such names.
[[maybe_unused]] constexpr const char* kEventWords[] = {
    // What the link did, and what the operator decided.
    QT_TRANSLATE_NOOP("event", "up"),
    QT_TRANSLATE_NOOP("event", "lost"),
    QT_TRANSLATE_NOOP("event", "telemetry lost"),
    QT_TRANSLATE_NOOP("event", "approve"),
    QT_TRANSLATE_NOOP("event", "choose"),
    QT_TRANSLATE_NOOP("event", "drive"),
    QT_TRANSLATE_NOOP("event", "explore"),
    QT_TRANSLATE_NOOP("event", "abort"),
    QT_TRANSLATE_NOOP("event", "forget"),
    QT_TRANSLATE_NOOP("event", "restore"),
    QT_TRANSLATE_NOOP("event", "halt"),
    QT_TRANSLATE_NOOP("event", "override"),
    QT_TRANSLATE_NOOP("event", "refuse"),
    QT_TRANSLATE_NOOP("event", "release stop"),
    QT_TRANSLATE_NOOP("event", "second method"),
    QT_TRANSLATE_NOOP("event", "stop"),
    QT_TRANSLATE_NOOP("event", "settings"),
    QT_TRANSLATE_NOOP("event", "forward"),
    QT_TRANSLATE_NOOP("event", "back"),
    QT_TRANSLATE_NOOP("event", "none"),
    QT_TRANSLATE_NOOP("event", "confirm to arm"),
    QT_TRANSLATE_NOOP("event", "waiting for the robot to arm"),
    QT_TRANSLATE_NOOP("event", "armed"),
    // Of the session itself, and of marks in it.
    QT_TRANSLATE_NOOP("event", "begun"),
    QT_TRANSLATE_NOOP("event", "continued"),
    QT_TRANSLATE_NOOP("event", "ended"),
    QT_TRANSLATE_NOOP("event", "recovered"),
    QT_TRANSLATE_NOOP("event", "merged"),
    QT_TRANSLATE_NOOP("event", "missing"),
    QT_TRANSLATE_NOOP("event", "log"),
    QT_TRANSLATE_NOOP("event", "clock"),
    QT_TRANSLATE_NOOP("event", "operator"),
    // Alarms, by what they are about; "disarmed" is what arming comes to, too.
    QT_TRANSLATE_NOOP("event", "silence"),
    QT_TRANSLATE_NOOP("event", "link"),
    QT_TRANSLATE_NOOP("event", "bus"),
    QT_TRANSLATE_NOOP("event", "foreign"),
    QT_TRANSLATE_NOOP("event", "dropped"),
    QT_TRANSLATE_NOOP("event", "checksum"),
    QT_TRANSLATE_NOOP("event", "disarmed"),
    QT_TRANSLATE_NOOP("event", "sensors"),
    QT_TRANSLATE_NOOP("event", "model"),
    QT_TRANSLATE_NOOP("event", "panel"),
    QT_TRANSLATE_NOOP("event", "exploration"),
    QT_TRANSLATE_NOOP("event", "recording"),
    // A button of the panel; the others are decisions, too.
    QT_TRANSLATE_NOOP("event", "atem"),
};

constexpr const char* kSimulated = QT_TRANSLATE_NOOP("source", "SIMULATED ROBOT");
constexpr const char* kReplay = QT_TRANSLATE_NOOP("source", "REPLAY %1");

/// What a text has %1, %2 … for, in their places.
template <class Value>
QString filled(const QString& text, Value&& valueOf)
{
    static const QRegularExpression kPlace(QStringLiteral("%([1-9])"));
    QString result;
    qsizetype done = 0;
    for (auto place = kPlace.globalMatch(text); place.hasNext();) {
        const QRegularExpressionMatch match = place.next();
        result += text.mid(done, match.capturedStart() - done) + valueOf(match.captured(1).toInt());
        done = match.capturedEnd();
    }
    return result + text.mid(done);
}

/// Sentences with places for more than numbers.  What stands there is a sentence again, where it is known.
const char* const kOpenSentences[]{
    // Chains that are stuck: "> 100" is no number.
    QT_TRANSLATE_NOOP("core",
                      "chains not converged: R-hat %1 (limit %2), effective draws %3 (limit %4)"),
    // NOLINTNEXTLINE(bugprone-suspicious-missing-comma)
    QT_TRANSLATE_NOOP("core", "chains not converged when time was out: R-hat %1 (limit %2), "
                              "effective draws %3 (limit %4)"),
    // Of a kernel without CAN, or one that forbids it.
    QT_TRANSLATE_NOOP("core", "the kernel has no CAN sockets (%1)"),
    QT_TRANSLATE_NOOP("core", "this user may not open CAN sockets (%1)"),
    QT_TRANSLATE_NOOP("core", "a CAN socket cannot be opened (%1)"),
    // Of the panel's chip and its lines.
    QT_TRANSLATE_NOOP("core", "no GPIO chip named %1: this computer has none (no /dev/gpiochip*); "
                              "plug it in, or load its driver"),
    QT_TRANSLATE_NOOP("core", "no GPIO chip labelled %1: this computer has none (no "
                              "/dev/gpiochip*); plug it in, or load its driver"),
    QT_TRANSLATE_NOOP("core", "no GPIO chip named %1: there is %2"),
    QT_TRANSLATE_NOOP("core", "no GPIO chip labelled %1: there is %2"),
    QT_TRANSLATE_NOOP("core",
                      "several GPIO chips named %1: there is %2; say the chip's name instead"),
    QT_TRANSLATE_NOOP("core",
                      "several GPIO chips labelled %1: there is %2; say the chip's name instead"),
    QT_TRANSLATE_NOOP("core",
                      "%1 has no line named %2: its lines have no names: say offset instead"),
    QT_TRANSLATE_NOOP("core", "%1 has no line named %2: it has %3 and more"),
    QT_TRANSLATE_NOOP("core", "%1 has no line named %2: it has %3"),
    QT_TRANSLATE_NOOP("core", "%1 has several lines named %2: say offset instead"),
    QT_TRANSLATE_NOOP("core", "line %1 of %2 is asked for twice"),
    QT_TRANSLATE_NOOP("core", "line %1 of %2 is in use: %3 holds it; end that program, or wire the "
                              "panel to another line"),
    QT_TRANSLATE_NOOP("core", "it is open to the group %1; run: %2 (and log in again)"),
    QT_TRANSLATE_NOOP("core", "it is open to root only; run: %1 (and restart)"),
    QT_TRANSLATE_NOOP("core", "the panel's %1 does not obey: %2"),
    QT_TRANSLATE_NOOP("core", "the panel's button %1 was held when the panel came up: it counts as "
                              "not pressed until it is let go; if nobody holds it, its contact "
                              "sticks or its wires touch"),
    QT_TRANSLATE_NOOP("core", "the panel's button %1 has been held for longer than anybody "
                              "presses: it counts as not pressed until it is let go; if nobody "
                              "holds it, its contact sticks or its wires touch"),
    // Events of a session, and an input that a method needs.
    QT_TRANSLATE_NOOP("core", "%1 is unknown, and method %2 needs it"),
    QT_TRANSLATE_NOOP("core", "after %1"),
    QT_TRANSLATE_NOOP("core", "from %1, %2 frames, last link %3, %4 batches of which are not what "
                              "was recorded and left out"),
    QT_TRANSLATE_NOOP("core", "from %1, %2 frames, last link %3"),
};

/// One with places for more than numbers.
struct OpenSentence {
    explicit OpenSentence(const char* said) : source(said)
    {
        static const QRegularExpression kPlace(QStringLiteral("%[1-9]"));
        static const QRegularExpression kEscapedPlace(QStringLiteral("\\\\%[1-9]"));
        const QString text = QString::fromUtf8(source);
        for (const QString& between : text.split(kPlace))
            if (between.size() > literal.size()) literal = between;
        QString pattern =
            QRegularExpression::escape(text).replace(kEscapedPlace, QStringLiteral("(.+?)"));
        // What it begins with is one part: the file's name before it is another.
        if (text.startsWith(QLatin1Char('%')))
            pattern.replace(0, 5, QStringLiteral("((?:(?!: ).)+?)"));
        form.setPattern(QRegularExpression::anchoredPattern(pattern));
    }

    const char* source;
    QString literal;  ///< the longest piece between its places: quickly looked for
    QRegularExpression form;
};

const std::vector<OpenSentence>& openSentences()
{
    static const auto kAll = [] {
        std::vector<OpenSentence> all;
        for (const char* source : kOpenSentences) all.emplace_back(source);
        return all;
    }();
    return kAll;
}

/// What stands in a sentence's place, or before or behind ": ".
QString part(const QString& said)
{
    return said.contains(QLatin1Char(' ')) ? format::sentence(said.toStdString()) : said;
}

/// As it is among those; empty: it is not.
QString translatedOpen(const QString& whole)
{
    for (const OpenSentence& open : openSentences()) {
        if (!whole.contains(open.literal)) continue;
        const QRegularExpressionMatch match = open.form.match(whole);
        if (!match.hasMatch()) continue;
        const QString found = QCoreApplication::translate("core", open.source);
        if (found == QString::fromUtf8(open.source)) return {};
        return filled(found, [&match](int place) { return part(match.captured(place)); });
    }
    return {};
}

/// As it is among those with numbers; empty: it is not.
QString translated(const QString& whole)
{
    static const QRegularExpression kNumber(
        QStringLiteral("(?<![A-Za-z0-9])[+-]?[0-9]+(\\.[0-9]+)?(e[+-]?[0-9]+)?"));
    QString pattern;
    QStringList numbers;
    qsizetype done = 0;
    for (auto number = kNumber.globalMatch(whole); number.hasNext();) {
        const QRegularExpressionMatch match = number.next();
        numbers << match.captured();
        pattern += whole.mid(done, match.capturedStart() - done)
                 + QStringLiteral("%%1").arg(numbers.size());
        done = match.capturedEnd();
    }
    pattern += whole.mid(done);
    const QString found = QCoreApplication::translate("core", pattern.toUtf8().constData());
    if (found == pattern) return {};
    return filled(found, [&numbers](int place) { return numbers.value(place - 1); });
}

}  // namespace

QString format::sentence(std::string_view english)
{
    QString whole = text(english);
    if (const QString known = QCoreApplication::translate("core", std::string(english).c_str());
        known != whole)
        return text(known.toStdString());
    if (QString known = translated(whole); !known.isEmpty()) return known;
    if (QString known = translatedOpen(whole); !known.isEmpty()) return known;
    // "models/mine.ttm: cannot be opened: No such file or directory"
    const QString kJoint = QStringLiteral(": ");
    const qsizetype at = whole.indexOf(kJoint);
    if (at < 0) return whole;
    return part(whole.left(at)) + kJoint + part(whole.mid(at + kJoint.size()));
}

QString format::eventWord(std::string_view english)
{
    return line(QCoreApplication::translate("event", std::string(english).c_str()).toStdString());
}

QString format::sourceName(std::string_view english)
{
    static const std::string kReplayed =
        std::string(kReplay).substr(0, std::string(kReplay).find('%'));
    if (english == kSimulated) return QCoreApplication::translate("source", kSimulated);
    if (!english.starts_with(kReplayed)) return shownName(english);
    return QCoreApplication::translate("source", kReplay)
        .arg(shownName(english.substr(kReplayed.size())));
}

}  // namespace terratact
