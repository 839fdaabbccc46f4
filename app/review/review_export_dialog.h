#pragma once

#include <QDialog>
#include <QTimer>
#include <functional>
#include <memory>

#include "app/review/session_export_job.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QRadioButton;

namespace terratact {

/// What a review shows when somebody asks for a file of it.
struct ExportViewState {
    double now = 0.0;                ///< [s] of the session
    double first = 0.0, last = 0.0;  ///< [s] visible: from A to B, or of the timeline
    bool isCursors = false;          ///< it is from A to B
    double begin = 0.0, end = 0.0;   ///< [s] of the session
    std::int64_t scene = 0;          ///< that stands with an estimate; 0: none
};

/// Asks what of a session is to be a file, and writes it: what is shown at once, what is read from the session
/// beside the review, which goes on meanwhile.  Esc cancels that, and closes the dialog where nothing is written.
class ReviewExportDialog final : public QDialog {
    Q_OBJECT
public:
    struct Sources {
        QString session;  ///< its file
        std::function<ExportViewState()> poll;
        std::function<QStringList()> dbc;  ///< files that the operator has chosen
        // Why it could not be written; empty: it is.
        std::function<QString(const QString&path)> savePicture, saveNumbers;
    };
    ReviewExportDialog(Sources sources, QWidget* parent);
    ~ReviewExportDialog() override;

    void
    ask();  ///< shows itself and does not wait; what is visible is looked at as long as it is shown
    bool writes() const { return job_ != nullptr; }

    QComboBox* what() const { return what_; }
    QComboBox* format() const { return format_; }
    QRadioButton* visibleSpan() const { return visible_; }
    QRadioButton* wholeSession() const { return everything_; }
    QCheckBox* withPayload() const { return payload_; }
    QLineEdit* pathEdit() const { return path_; }
    QPushButton* exportButton() const { return export_; }
    QPushButton* cancelButton() const { return cancel_; }
    QProgressBar* progressBar() const { return progress_; }
    QLabel* resultLabel() const { return result_; }

    void reject() override;

private:
    QWidget* form();
    QWidget* span();
    QWidget* file();
    QWidget* buttons();
    void offerFormats();
    void showViewState();
    void showPayload();
    void showButtons();
    QString whyNotExport() const;  ///< empty: it may be written
    void takeFormat();
    void nameFile();
    void browse();
    QString path() const;  ///< with the format's ending
    void write();
    void begin(SessionExportJob::Wish wish);
    void wrote(const QString& trouble, qulonglong leftOut = 0, int damaged = 0,
               int withoutColumns = 0);

    Sources sources_;
    ExportViewState viewState_;
    std::unique_ptr<SessionExportJob> job_;  ///< null: nothing is being written
    QString to_;  ///< the file of the newest export; path() may be another one by now
    QTimer look_;
    QString named_;  ///< as it was proposed; another one is the operator's

    // Qt's parents own the widgets.
    QComboBox* what_ = nullptr;
    QComboBox* format_ = nullptr;
    QRadioButton* visible_ = nullptr;
    QRadioButton* everything_ = nullptr;
    QCheckBox* payload_ = nullptr;  ///< the signals that DBC files describe
    QLabel* moment_ = nullptr;
    QLineEdit* path_ = nullptr;
    QPushButton* browse_ = nullptr;
    QPushButton* export_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel* result_ = nullptr;
};

}  // namespace terratact
