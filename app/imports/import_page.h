#pragma once

#include <QWidget>

#include "app/imports/import_work.h"

class QComboBox;
class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;

namespace terratact {

/// What a recording of another program holds, the mapping that makes a session of it, and what is missing. The mapping
/// may be edited, or read from a file. The recording is read in a thread; it can be cancelled at any time.
class ImportPage final : public QWidget {
    Q_OBJECT
public:
    /// folder: where a session is proposed to be written.
    ImportPage(const QString& file, const RobotFile& robot, QString folder,
               QWidget* parent = nullptr);

    void importInto(const QString& session);  ///< imports by the shown mapping

    QPlainTextEdit* holdsText() const { return holds_; }
    QPlainTextEdit* mappingText() const { return mapping_; }
    QPlainTextEdit* resultText() const { return result_; }
    QComboBox* mappingChoice() const { return choice_; }
    QPushButton* checkButton() const { return check_; }
    QPushButton* importButton() const { return import_; }
    QPushButton* cancelButton() const { return cancel_; }
    QProgressBar* progress() const { return progress_; }
    QLabel* stateLabel() const { return state_; }

signals:
    void sessionMade(const QString& path);

private:
    void build();
    void connectWork();
    void chooseMapping(int index);
    void readMappingFile(const QString& path);
    void askForSession();
    void showBusy(const QString& what);
    void showIdle(const QString& what);
    std::string mapping() const;

    QString file_, folder_, proposed_;
    ImportWork* work_ = nullptr;
    QPlainTextEdit* holds_ = nullptr;
    QPlainTextEdit* mapping_ = nullptr;
    QPlainTextEdit* result_ = nullptr;
    QComboBox* choice_ = nullptr;
    QPushButton* check_ = nullptr;
    QPushButton* import_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel* state_ = nullptr;
};

}  // namespace terratact
