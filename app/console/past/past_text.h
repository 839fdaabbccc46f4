#pragma once

#include <QCoreApplication>
#include <QString>

namespace terratact {

struct PastEstimate;

// Texts about an estimate of the past.
class PastText {
    Q_DECLARE_TR_FUNCTIONS(PastText)
public:
    static QString time(const PastEstimate& past);     ///< "12:03:11"
    static QString verdict(const PastEstimate& past);  ///< in words, per side where they differ
    /// Returns what it was made from, and by which method: "press · local", "probe · trail".
    static QString origin(const PastEstimate& past);
    /// Returns its error against the truth and against the arm, or that it is not known.
    static QString error(const PastEstimate& past);
    /// Returns the note in the picture: it is not the present estimate.
    static QString note(const PastEstimate& past);
};

}  // namespace terratact
