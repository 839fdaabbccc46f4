#include "app/review/export/review_export_choices.h"

#include <QCoreApplication>

namespace terratact {

const std::array<ExportChoice, 10>& exportChoices()
{
    static const std::array<ExportChoice, 10> all{
        {{QT_TRANSLATE_NOOP("ReviewExport", "Picture of the terrain"),
          "terrain",
          {"png", "svg", "pdf"},
          ExportSource::Picture},
         {QT_TRANSLATE_NOOP("ReviewExport", "Numbers of this time"),
          "numbers",
          {"csv"},
          ExportSource::Numbers},
         {QT_TRANSLATE_NOOP("ReviewExport", "Report of the scene, one page"),
          "report",
          {"pdf", "svg", "png", "html"},
          ExportSource::Report},
         {QT_TRANSLATE_NOOP("ReviewExport", "Mission report, the whole session"),
          "mission",
          {"pdf", "html"},
          ExportSource::Mission},
         {QT_TRANSLATE_NOOP("ReviewExport", "Strip of felt ground, the whole session"),
          "strip",
          {"svg", "png", "pdf", "html", "csv", "ply"},
          ExportSource::Strip},
         {QT_TRANSLATE_NOOP("ReviewExport", "CAN frames"),
          "frames",
          {"csv", "log", "asc", "mcap"},
          ExportSource::Rows,
          ExportKind::Frames},
         {QT_TRANSLATE_NOOP("ReviewExport", "Signals, a column for each"),
          "signals",
          {"csv", "mcap"},
          ExportSource::Rows,
          ExportKind::Signals},
         {QT_TRANSLATE_NOOP("ReviewExport", "Estimates, a row for each bin"),
          "estimates",
          {"csv", "mcap"},
          ExportSource::Rows,
          ExportKind::Estimates},
         {QT_TRANSLATE_NOOP("ReviewExport", "Events"),
          "events",
          {"csv", "mcap"},
          ExportSource::Rows,
          ExportKind::Events},
         {QT_TRANSLATE_NOOP("ReviewExport", "Frames, signals, estimates and events"),
          "all",
          {"mcap"}}}};
    return all;
}

}  // namespace terratact
