// SPDX-License-Identifier: GPL-3.0-or-later
// How numbers, words and arrays stand in a session file; reading stops with an error where the file is damaged.
#pragma once

#include "core/error.h"
#include "core/types.h"
#include "document/file_path.h"

#include <QDataStream>
#include <QString>

#include <string>
#include <utility>
#include <vector>

namespace loopmend {

/// Words and numbers in one fixed layout, little-endian, doubles in full.
class SessionWriter {
 public:
  explicit SessionWriter(QByteArray& bytes) : out_(&bytes, QIODevice::WriteOnly) { settle(out_); }
  static void settle(QDataStream& stream) {
    stream.setVersion(QDataStream::Qt_5_15);
    stream.setByteOrder(QDataStream::LittleEndian);
    stream.setFloatingPointPrecision(QDataStream::DoublePrecision);
  }
  void put(qint32 value) { out_ << value; }
  void put(quint64 value) { out_ << value; }
  void put(double value) { out_ << value; }
  void put(const QString& value) { out_ << value; }
  void put(const Vec3& value) {
    for (double x : value) put(x);
  }
  void put(const std::vector<int>& values) {
    put(static_cast<quint64>(values.size()));
    raw(values.data(), values.size() * sizeof(int));
  }
  void put(const std::vector<double>& values) {
    put(static_cast<quint64>(values.size()));
    raw(values.data(), values.size() * sizeof(double));
  }
  void put(const Points& values) {
    put(static_cast<quint64>(values.size()));
    raw(values.data(), values.size() * sizeof(Vec3));
  }
  void put(const std::vector<Color>& values) {
    put(static_cast<quint64>(values.size()));
    raw(values.data(), values.size() * sizeof(Color));
  }
  void put(const Triangles& values) {
    put(static_cast<quint64>(values.size()));
    raw(values.data(), values.size() * sizeof(Triangle));
  }
  void raw(const void* data, std::size_t size) {
    out_.writeRawData(static_cast<const char*>(data), static_cast<int>(size));
  }

 private:
  QDataStream out_;
};

class SessionReader {
 public:
  SessionReader(const QByteArray& bytes, const QString& path) : in_(bytes), path_(path) { SessionWriter::settle(in_); }

  [[noreturn]] void fail(Message problem) const {
    throw ReadError(file_path(path_), std::move(problem), say("byte %1", in_.device()->pos()),
                    say("Open the scan itself instead; the session file is damaged."));
  }
  template <class T>
  T number() {
    T value{};
    in_ >> value;
    check();
    return value;
  }
  QString text() { return number<QString>(); }
  Vec3 vector() {
    Vec3 v;
    for (double& x : v) x = number<double>();
    return v;
  }
  template <class T>
  std::vector<T> array() {
    const auto count = number<quint64>();
    if (count > static_cast<quint64>(in_.device()->bytesAvailable()) / sizeof(T)) fail(say("the file ends too early"));
    std::vector<T> values(static_cast<std::size_t>(count));
    in_.readRawData(reinterpret_cast<char*>(values.data()), static_cast<int>(count * sizeof(T)));
    check();
    return values;
  }
  /// A count of things that take at least `bytes_each`.
  int count(quint64 bytes_each) {
    const auto n = number<quint64>();
    if (n > static_cast<quint64>(in_.device()->bytesAvailable()) / bytes_each) fail(say("the file ends too early"));
    return static_cast<int>(n);
  }
  /// An enumerator up to `last`.
  template <class E>
  E word(E last) {
    const auto value = number<qint32>();
    if (value < 0 || value > static_cast<qint32>(last)) fail(say("a word is not known"));
    return static_cast<E>(value);
  }
  bool at_end() const { return in_.atEnd(); }

 private:
  void check() const {
    if (in_.status() != QDataStream::Ok) fail(say("the file ends too early"));
  }
  QDataStream in_;
  QString path_;
};

}  // namespace loopmend
