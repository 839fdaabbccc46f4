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
    static QString verdict(const PastEstimate& past);  ///< per side if the sides differ
    /// Returns the source and the method of the estimate: "press · local", "probe · trail".
    static QString origin(const PastEstimate& past);
    /// Returns the error against the truth and against the arm, or a text that it is unknown.
    static QString error(const PastEstimate& past);
    /// Returns the picture's note that this is not the present estimate.
    static QString note(const PastEstimate& past);
};

}  // namespace terratact
