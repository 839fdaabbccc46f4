#pragma once

#include <gtest/gtest.h>

#include <QByteArray>
#include <QDir>
#include <QString>
#include <QtGlobal>
#include <string>

namespace terratact {

/// A home of the test's own, with a documents folder.
class OwnDocuments {
public:
    explicit OwnDocuments(const std::string& home)
        : folder_(QString::fromStdString(home) + QStringLiteral("/Documents"))
    {
        qputenv("HOME", QByteArray::fromStdString(home));
        qunsetenv("XDG_CONFIG_HOME");
        EXPECT_TRUE(QDir().mkpath(folder_));
    }
    ~OwnDocuments()
    {
        qputenv("HOME", home_);
        if (!config_.isNull()) qputenv("XDG_CONFIG_HOME", config_);
    }
    OwnDocuments(const OwnDocuments&) = delete;
    OwnDocuments& operator=(const OwnDocuments&) = delete;
    const QString& folder() const { return folder_; }

private:
    QByteArray home_ = qgetenv("HOME"), config_ = qgetenv("XDG_CONFIG_HOME");
    QString folder_;
};

}  // namespace terratact
