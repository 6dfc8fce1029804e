// SPDX-License-Identifier: GPL-3.0-or-later
// How numbers, words and arrays stand in a session file; reading stops with an error where the file is damaged.
#pragma once

#include "core/error.h"
#include "core/types.h"
#include "document/file_path.h"

#include <QDataStream>
#include <QString>

#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace loopmend {

/// A Thing, constant or not: one function names the fields for writing and for reading (session_patch.cpp).
template <class T, class Thing>
concept Is = std::same_as<std::remove_const_t<T>, Thing>;

/// Words and numbers in one fixed layout, little-endian, doubles in full. Each of its functions has one of the same name in
/// SessionReader, which reads what this one writes.
class SessionWriter {
 public:
  explicit SessionWriter(QByteArray& bytes) : out_(&bytes, QIODevice::WriteOnly) { settle(out_); }
  static void settle(QDataStream& stream) {
    stream.setVersion(QDataStream::Qt_5_15);
    stream.setByteOrder(QDataStream::LittleEndian);
    stream.setFloatingPointPrecision(QDataStream::DoublePrecision);
  }
  void raw(const void* data, std::size_t size) {
    out_.writeRawData(static_cast<const char*>(data), static_cast<int>(size));
  }

  void number(double value) { out_ << value; }
  void whole(int value) { out_ << static_cast<qint32>(value); }
  void whole(std::uint64_t value) { out_ << static_cast<quint64>(value); }
  void flag(bool value) { whole(static_cast<int>(value)); }
  void text(const QString& value) { out_ << value; }
  void text(const std::string& value) { out_ << QString::fromStdString(value); }
  template <class E>
  void word(E value, E /*last*/) {
    whole(static_cast<int>(value));
  }
  void vector(const Vec3& value) {
    for (double x : value) number(x);
  }
  template <class T>
  void array(const std::vector<T>& values) {
    whole(std::uint64_t{values.size()});
    raw(values.data(), values.size() * sizeof(T));
  }
  template <class T, class Each>
  void list(const std::vector<T>& values, std::size_t /*bytes_each*/, const Each& each) {
    whole(std::uint64_t{values.size()});
    for (const T& value : values) each(value);
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

  void number(double& value) { take(value); }
  void whole(int& value) { value = taken<qint32>(); }
  void whole(std::uint64_t& value) { value = taken<quint64>(); }
  void flag(bool& value) { value = taken<qint32>() != 0; }
  void text(QString& value) { take(value); }
  void text(std::string& value) { value = taken<QString>().toStdString(); }
  /// An enumerator up to `last`.
  template <class E>
  void word(E& value, E last) {
    const auto read = taken<qint32>();
    if (read < 0 || read > static_cast<qint32>(last)) fail(say("a word is not known"));
    value = static_cast<E>(read);
  }
  void vector(Vec3& value) {
    for (double& x : value) number(x);
  }
  template <class T>
  void array(std::vector<T>& values) {
    values.resize(count(sizeof(T)));
    in_.readRawData(reinterpret_cast<char*>(values.data()), static_cast<int>(values.size() * sizeof(T)));
    check();
  }
  /// Of things that take at least `bytes_each`, each read by each(thing).
  template <class T, class Each>
  void list(std::vector<T>& values, std::size_t bytes_each, const Each& each) {
    for (std::size_t n = count(bytes_each); n > 0; --n) each(values.emplace_back());
  }
  /// A count of things that take at least `bytes_each`.
  std::size_t count(std::size_t bytes_each) {
    const auto n = taken<quint64>();
    if (n > static_cast<quint64>(in_.device()->bytesAvailable()) / bytes_each) fail(say("the file ends too early"));
    return static_cast<std::size_t>(n);
  }
  /// The next value, of this type of Qt.
  template <class T>
  T taken() {
    T value{};
    take(value);
    return value;
  }
  bool at_end() const { return in_.atEnd(); }

 private:
  template <class T>
  void take(T& value) {
    in_ >> value;
    check();
  }
  void check() const {
    if (in_.status() != QDataStream::Ok) fail(say("the file ends too early"));
  }

  QDataStream in_;
  QString path_;
};

/// Whether a stream is one that reads.
template <class Stream>
constexpr bool is_reading = std::same_as<std::remove_reference_t<Stream>, SessionReader>;

}  // namespace loopmend
