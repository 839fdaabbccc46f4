#pragma once

#include <QList>
#include <QString>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "app/link/can_source.h"
#include "app/mission/estimation.h"
#include "app/shell/event_watch.h"
#include "app/shell/page.h"
#include "drivers/operator_panel.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace terratact {

class LoopMeter;

/// A heading with names and values below it.
struct DiagnosticsSection {
    QString title;
    QList<std::pair<QString, QString>> lines{};
};

/// What stays as it is while the program runs: versions, processor, permissions.  Looks at /dev, /proc and the
/// network stack once.
QList<DiagnosticsSection> standingDiagnostics();

/// Whether CAN sockets can be opened; why not and what mends it, where not.  socketError: of canSocketError().
QString canSocketWords(int socketError);

/// An operator's panel, and how it fares.
struct PanelFacts {
    PanelReport report{};
    bool answers = false;
    PerContact<std::uint64_t> presses{};
    std::vector<double> stopLatencies{};  ///< [s]
};

/// What a console works with, and how it fares.
struct ConsoleFacts {
    std::optional<double> telemetryAge{};  ///< [s]; empty: none came yet
    double telemetryRate = 0.0;            ///< [Hz]
    QString bus{};                         ///< what is the matter with it; empty: there is none
    std::optional<CanSource::Waiting> waiting{};  ///< of a bus
    std::optional<PanelFacts> panel{};            ///< empty: there is none
    bool estimating = false;
    QString source{}, robot{}, robotDetails{};
    ModelInUse model{};
    std::vector<LongEvent> longest{};  ///< since the start
};

/// These facts, and frame times, latency and the lateness of the event loop.
QList<DiagnosticsSection> consoleDiagnostics(const ConsoleFacts& facts, const LoopMeter& meter);

/// Resident memory of this process [B]; 0 where it cannot be read.
double residentMemory();

/// "Title\n  name: value\n…", for a report.
QString plainText(const QList<DiagnosticsSection>& sections);

/// What somebody who helps from afar asks for first; as text by one button.
class DiagnosticsPage final : public Page {
    Q_OBJECT
public:
    using Look = std::function<QList<DiagnosticsSection>()>;

    /// look: what changes, asked for once a second while the page is visible; the same sections and lines each
    /// time.
    explicit DiagnosticsPage(Look look, QWidget* parent = nullptr);
    void refresh(double now) override;

    QString text() const;  ///< what the button copies
    QPushButton* copyButton() const { return copy_; }

private:
    QWidget* cardOf(const DiagnosticsSection& section, QList<QLabel*>* values);

    Look look_;
    QList<DiagnosticsSection> standing_;
    QList<QLabel*> values_;  ///< of what changes
    QPushButton* copy_ = nullptr;
    double shownAt_ = 0.0;  ///< [s]
};

}  // namespace terratact
