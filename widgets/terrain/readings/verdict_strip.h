#pragma once

#include <QFrame>

#include "core/infer/verdict/two_track_verdict.h"
#include "core/limits.h"

class QBoxLayout;
class QLabel;
class QPushButton;

namespace terratact {

/// The verdict for driving on: a badge of word, shape and colour. Beside it stands P(step ahead > limit) with its
/// Monte-Carlo error, and below it the reason. For two tracks the badge has the robot's answer, and the line beside it
/// those of both sides.
class VerdictStrip final : public QFrame {
    Q_OBJECT
public:
    explicit VerdictStrip(QWidget* parent = nullptr);

    /// probe: text of the expected gain of a probe; empty: none is proposed. The verdict must be for limit().
    void setVerdict(const TwoTrackVerdict& verdict, const QString& probe = {});
    /// Shows the verdict of one plane.
    void setVerdict(const Verdict& verdict, const QString& probe = {});
    void setNothing(const QString& why);  ///< there is no estimate, so there is no verdict
    void setLimit(double metres);         ///< clamped to kMinLimit … kMaxLimit
    void setStacked(bool stacked);        ///< puts the texts below the badge, for a narrow column

    // Texts of a verdict.
    static QString answerOf(const Verdict& verdict);                     ///< "✔ CLEAR"
    static QString probabilityOf(const Verdict& verdict, double limit);  ///< limit: [m]
    /// Returns what the verdict means, or why there is none.
    static QString whyOf(const Verdict& verdict);
    /// Returns why the verdict is CANNOT TELL, in few words. isOfTwo: in even fewer, one of two texts.
    static QString brieflyOf(const Verdict& verdict, bool isOfTwo = false);

    double limit() const { return limit_; }
    QString badge() const;
    QString question() const;
    QString reason() const;
    QPushButton* lowerButton() const { return lower_; }
    QPushButton* raiseButton() const { return raise_; }

    static constexpr double kMinLimit = kLowestStepLimit, kMaxLimit = kHighestStepLimit,
                            kLimitStep = 0.01;  ///< [m]

signals:
    void limitChosen(double metres);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void resizeToFont();
    void choose(double metres);
    void setTwoTracks(const TwoTrackVerdict& verdict, const QString& probe);
    void setAnswer(const QString& answer, const QString& stepVerdict, bool withheld);
    void nameQuestion(bool isOfSides);
    void fitSides();  ///< shortens the line of both sides to the room

    double limit_ = kStepLimit;
    bool stacked_ = false;
    bool withheld_ = false;
    bool sidesWrap_ = false;      ///< the line of both sides needs two lines
    QString sides_, shortSides_;  ///< line of both sides; empty: another line is shown
    QBoxLayout* row_ = nullptr;
    QBoxLayout* head_ = nullptr;  ///< the badge and the buttons in the stacked layout
    QLabel* badge_ = nullptr;
    QLabel* question_ = nullptr;
    QLabel* reason_ = nullptr;
    QPushButton* lower_ = nullptr;
    QPushButton* raise_ = nullptr;
};

}  // namespace terratact
